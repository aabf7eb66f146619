#include "robot_app/processes/config/variables.h"

#include <vector>

#include "bt_core/base/diagnostic.h"

namespace coppice::robot::processes {
namespace {

using Report = std::function<void(const std::string& message, const std::string& hint)>;

constexpr int kDeepest = 16;  // defaults within defaults

std::string Fill(const std::string& text, const Variables& variables, const Report& report,
                 int depth);

// Of the brace that was opened just before `position`; npos if there is none.
std::size_t MatchingBrace(const std::string& text, std::size_t position) {
  int open = 1;
  for (; position < text.size(); ++position) {
    if (text.compare(position, 2, "${") == 0) ++open;
    if (text[position] == '}' && --open == 0) return position;
  }
  return std::string::npos;
}

std::string Lookup(const std::string& expression, const Variables& variables, const Report& report,
                   int depth) {
  const std::size_t separator = expression.find(":-");
  const std::string name = expression.substr(0, separator);
  const auto found = variables.find(name);
  if (found != variables.end()) return found->second;
  if (separator != std::string::npos) {
    return Fill(expression.substr(separator + 2), variables, report, depth + 1);
  }
  std::vector<std::string> names;
  for (const auto& [known, value] : variables) names.push_back(known);
  const std::string hint = DidYouMean(name, names);
  report("variable \"" + name + "\" has no value",
         hint.empty() ? "give it with --set " + name + "=VALUE" : hint);
  return "";
}

std::string Fill(const std::string& text, const Variables& variables, const Report& report,
                 int depth) {
  if (depth > kDeepest) {
    report("more than " + std::to_string(kDeepest) + " defaults within each other", "");
    return "";
  }
  std::string filled;
  std::size_t position = 0;
  while (true) {
    const std::size_t begin = text.find("${", position);
    filled += text.substr(position, begin - position);
    if (begin == std::string::npos) return filled;
    const std::size_t end = MatchingBrace(text, begin + 2);
    if (end == std::string::npos) {
      report("\"${\" without \"}\" in \"" + text + "\"", "");
      return filled;
    }
    filled += Lookup(text.substr(begin + 2, end - begin - 2), variables, report, depth);
    if (filled.size() > kLongestFilled) {
      report("stands for more than " + std::to_string(kLongestFilled) + " bytes", "");
      return "";
    }
    position = end + 1;
  }
}

}  // namespace

std::string FillVariables(const std::string& text, const Variables& variables,
                          const Report& report) {
  return Fill(text, variables, report, 0);
}

}  // namespace coppice::robot::processes
