#include "bt_core/base/verbs.h"

#include <algorithm>
#include <iostream>

#include "bt_core/base/diagnostic.h"

namespace coppice {
namespace {

std::string Usage(const std::string& program, const std::vector<Verb>& verbs) {
  std::string text = "usage: " + program + " VERB ...\n\n";
  for (const Verb& verb : verbs) {
    std::string name = verb.name;
    name.resize(std::max<std::size_t>(10, name.size() + 2), ' ');
    text += "  " + name + verb.command.summary + "\n";
  }
  return text + "\n`" + program + " VERB --help` says more.\n";
}

int RefuseVerb(const std::string& program, const std::vector<Verb>& verbs,
               const std::string& wrong) {
  std::vector<std::string> names;
  for (const Verb& verb : verbs) names.emplace_back(verb.name);
  const std::string hint = DidYouMean(wrong, names);
  std::cerr << program << ": unknown verb \"" << wrong << "\""
            << (hint.empty() ? "" : " (" + hint + ")") << "\n";
  return 2;
}

}  // namespace

int RunVerb(const std::string& program, const std::vector<Verb>& verbs,
            const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    std::cerr << Usage(program, verbs);
    return 2;
  }
  if (arguments[0] == "--help" || arguments[0] == "-h") {
    std::cout << Usage(program, verbs);
    return FinishOutput(0);
  }
  for (const Verb& verb : verbs) {
    if (arguments[0] != verb.name) continue;
    const Options options = ParseOptions(verb.command, {arguments.begin() + 1, arguments.end()});
    return options.exit ? *options.exit : FinishOutput(verb.run(options));
  }
  return RefuseVerb(program, verbs, arguments[0]);
}

}  // namespace coppice
