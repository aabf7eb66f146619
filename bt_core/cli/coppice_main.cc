// `coppice VERB ...`, like git: a verb of the table below, or the program coppice-VERB beside this
// one.
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <utility>

#include "bt_core/base/diagnostic.h"
#include "bt_core/cli/replay/replay.h"
#include "bt_core/cli/verbs.h"

namespace {

struct Verb {
  const char* name;
  const char* summary;
  int (*run)(const coppice::Arguments&);
};

constexpr Verb kVerbs[] = {
    {"cat", "print a file, with attributes set", coppice::RunCat},
    {"check", "find what is wrong in tree files", coppice::RunCheck},
    {"convert", "turn a recorded run into another format", coppice::RunConvert},
    {"live", "watch and debug a robot", coppice::RunLive},
    {"nodes", "list the node types and their ports", coppice::RunNodes},
    {"record", "record a robot over the network", coppice::RunRecord},
    {"replay", "go back and forth in a recorded run; why, verify, compare", coppice::RunReplay},
    {"run", "run a tree of built-in nodes", coppice::RunTree},
    {"stats", "figures of a recorded run, per node", coppice::RunStats},
    {"test", "play scenarios with whole trees", coppice::RunTest},
    {"trace", "run a tree with scripted leaves", coppice::RunTrace},
    {"upgrade", "make trees of format 3 trees of format 4", coppice::RunUpgrade},
};

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

int Usage() {
  std::cout << "usage: coppice VERB ...\n\n";
  for (const Verb& verb : kVerbs) {
    std::cout << "  " << verb.name << std::string(10 - std::strlen(verb.name), ' ') << verb.summary
              << "\n";
  }
  const std::vector<std::string> others = OtherPrograms();
  for (const auto& [verb, summary] : kEditorVerbs) {
    if (std::find(others.begin(), others.end(), verb) == others.end()) continue;
    std::cout << "  " << verb << std::string(10 - std::strlen(verb), ' ') << summary << "\n";
  }
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  const coppice::Arguments arguments(argv + 1, argv + argc);
  if (arguments.empty() || arguments[0] == "--help" || arguments[0] == "help") return Usage();
  for (const Verb& verb : kVerbs) {
    if (arguments[0] == verb.name) return verb.run({arguments.begin() + 1, arguments.end()});
  }
  const std::string program = FolderOfThisProgram() / ("coppice-" + arguments[0]);
  if (access(program.c_str(), X_OK) == 0) execv(program.c_str(), argv + 1);

  std::vector<std::string> names = OtherPrograms();
  for (const Verb& verb : kVerbs) names.emplace_back(verb.name);
  std::cerr << "coppice: no verb \"" << arguments[0] << "\" "
            << coppice::DidYouMean(arguments[0], names) << "\n";
  return 2;
}
