#include <iostream>
#include <memory>

#include "bt_core/base/command_line.h"
#include "bt_core/cli/verbs.h"
#include "bt_core/engine/program.h"

namespace coppice {
namespace {

constexpr char kUsage[] =
    "coppice check FILE...\n"
    "  Loads each file with its includes and checks every tree in it: structure, names, ports, "
    "types.\n"
    "  Leaf types of the robot are not known here; their ports are not checked.";

// Stands for a leaf that only the robot's program knows.
class UnknownLeaf : public SyncAction {
 public:
  Status Run() override { return Status::kSuccess; }
};

bool CheckFile(const std::string& path) {
  auto registry = std::make_shared<Registry>();
  registry->SetFallback([](const std::string&) { return std::make_unique<UnknownLeaf>(); });
  Diagnostics loading;
  std::optional<Project> loaded = Project::FromFile(path, loading);
  std::cerr << loading.ToString();
  if (!loaded) return false;
  const auto project = std::make_shared<const Project>(*std::move(loaded));

  bool good = !project->has_errors();
  std::vector<std::string> printed;  // a tree that is used twice is checked twice
  for (const auto& [id, definition] : project->trees()) {
    Diagnostics diagnostics;
    Compile(project, registry, diagnostics, id);
    good = good && !diagnostics.has_errors();
    for (const Diagnostic& diagnostic : diagnostics.all()) {
      const std::string line = ToString(diagnostic);
      bool known = false;
      for (const std::string& old : printed) known = known || old == line;
      if (known) continue;
      printed.push_back(line);
      std::cerr << line << "\n";
    }
  }
  return good;
}

}  // namespace

int RunCheck(const Arguments& arguments) {
  const std::optional<Options> options = ParseOptions(arguments, {}, {}, kUsage);
  if (!options) return 2;
  if (options->files.empty()) {
    std::cerr << "no file given\nusage: " << kUsage << "\n";
    return 2;
  }
  bool good = true;
  for (const std::string& file : options->files) good = CheckFile(file) && good;
  return good ? 0 : 1;
}

}  // namespace coppice
