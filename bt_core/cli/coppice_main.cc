// `coppice VERB ...`, like git: a verb of the table below, or the program coppice-VERB beside this
// one.
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/base/version.h"
#include "bt_core/cli/verbs.h"

namespace {

// Programs of their own, which are there if the editor is.
constexpr std::pair<const char*, const char*> kEditorVerbs[] = {
    {"diff", "say and paint what became of the trees of a file"},
    {"edit", "open the graphical editor"},
    {"export", "paint trees as SVG, PDF, PNG, DOT or Markdown"},
};

std::filesystem::path FolderOfThisProgram() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

// The programs coppice-VERB beside this one, by their verbs.
std::vector<std::string> OtherPrograms() {
  std::vector<std::string> verbs;
  for (const auto& entry : std::filesystem::directory_iterator(FolderOfThisProgram())) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("coppice-", 0) == 0) verbs.push_back(name.substr(std::strlen("coppice-")));
  }
  return verbs;
}

void PrintVerb(const std::string& name, const std::string& summary) {
  std::cout << "  " << std::left << std::setw(12) << name << summary << "\n";
}

void PrintUsage() {
  std::cout << "usage: coppice VERB ...\n\n";
  for (const coppice::Verb& verb : coppice::Verbs()) {
    PrintVerb(verb.name(), verb.command().summary);
  }
  const std::vector<std::string> others = OtherPrograms();
  for (const auto& [verb, summary] : kEditorVerbs) {
    if (std::find(others.begin(), others.end(), verb) != others.end()) PrintVerb(verb, summary);
  }
  std::cout << "\nOf each: coppice VERB --help; of all: coppice --version\n";
}

int Run(const coppice::Arguments& arguments, char** argv) {
  if (arguments.empty()) return PrintUsage(), 2;
  if (arguments[0] == "--help" || arguments[0] == "help") return PrintUsage(), 0;
  if (arguments[0] == "--version") {
    std::cout << "coppice " << coppice::kVersion << "\n";
    return 0;
  }
  std::vector<std::string> names = OtherPrograms();
  for (const coppice::Verb& verb : coppice::Verbs()) {
    if (arguments[0] == verb.name()) return verb.run({arguments.begin() + 1, arguments.end()});
    names.push_back(verb.name());
  }
  const std::string program = FolderOfThisProgram() / ("coppice-" + arguments[0]);
  if (access(program.c_str(), X_OK) == 0) execv(program.c_str(), argv + 1);
  std::cerr << "coppice: no verb \"" << arguments[0] << "\" "
            << coppice::DidYouMean(arguments[0], names) << "\n";
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  return coppice::FinishOutput(Run({argv + 1, argv + argc}, argv));
}
