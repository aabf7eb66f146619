#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <utility>

#include "bt_core/base/command_line.h"
#include "bt_core/base/json.h"
#include "bt_core/cli/plugins.h"
#include "bt_core/cli/verbs.h"
#include "bt_core/engine/compile/check_project.h"
#include "bt_core/engine/compile/model_registry.h"

namespace coppice {
namespace {

Diagnostics Check(const Options& options, const std::shared_ptr<Registry>& registry) {
  Diagnostics diagnostics;
  if (options.Has("--models")) {
    const auto models = Project::FromFile(options.Get("--models"), diagnostics);
    if (models) {
      RemoveContradicted(*models, *registry, diagnostics);
      AddModels(*models, *registry);
    }
  }
  std::optional<Project> project = Project::FromFiles(options.files, diagnostics);
  if (!project) return diagnostics;
  CheckProject(std::make_shared<const Project>(*std::move(project)), registry,
               {options.Has("--models")}, diagnostics);
  return diagnostics;
}

// By file in the order of first mention, then by line and column.
std::vector<Diagnostic> Sorted(const Diagnostics& diagnostics) {
  std::vector<Diagnostic> sorted = diagnostics.all();
  std::map<std::string, std::size_t> files;
  for (const Diagnostic& diagnostic : sorted) {
    files.emplace(diagnostic.where.file, files.size());
  }
  const auto place = [&files](const Diagnostic& d) {
    return std::make_tuple(files.at(d.where.file), d.where.line, d.where.column);
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return place(a) < place(b); });
  return sorted;
}

bool IsOfNoModel(const Diagnostic& diagnostic) {
  return diagnostic.about.kind == ProblemKind::kNoModel;
}

// A file of another robot has dozens of types that nobody describes: one line names them all.
std::vector<Diagnostic> Folded(const std::vector<Diagnostic>& sorted) {
  std::map<std::string, std::vector<std::string>> types;  // by file
  for (const Diagnostic& d : sorted) {
    if (IsOfNoModel(d)) types[d.where.file].push_back(d.about.name);
  }
  std::vector<Diagnostic> folded;
  for (const Diagnostic& d : sorted) {
    std::vector<std::string>& names = types[d.where.file];
    if (!IsOfNoModel(d) || names.size() == 1) {
      folded.push_back(d);
    } else if (names.size() > 1) {
      folded.push_back(d);
      folded.back().message = std::to_string(names.size()) +
                              " node types are not built in: their ports are not checked, nor "
                              "their numbers of children";
      for (const std::string& name : names) {
        folded.back().hint += (&name == &names.front() ? "" : ", ") + name;
      }
      names.clear();
    }
  }
  return folded;
}

std::string ToJson(const Diagnostic& diagnostic) {
  const SourceLocation& where = diagnostic.where;
  return "{\"file\":" + JsonString(where.file) + ",\"line\":" + std::to_string(where.line) +
         ",\"column\":" + std::to_string(where.column) + ",\"severity\":" +
         (diagnostic.severity == Severity::kError ? "\"error\"" : "\"warning\"") +
         ",\"message\":" + JsonString(diagnostic.message) +
         ",\"hint\":" + JsonString(diagnostic.hint) + "}";
}

void PrintJson(const std::vector<Diagnostic>& diagnostics) {
  std::cout << "[";
  const char* separator = "\n  ";
  for (const Diagnostic& diagnostic : diagnostics) {
    std::cout << separator << ToJson(diagnostic);
    separator = ",\n  ";
  }
  std::cout << (diagnostics.empty() ? "]\n" : "\n]\n");
}

}  // namespace

const Command& CheckCommand() {
  static const Command command{
      "coppice check",
      "find what is wrong in tree files",
      {"FILE...", 1, kAnyNumber},
      R"(Checks every tree in the files, which are taken as one project, and in what they include:
structure, names, ports, types, scripts. All problems are printed; 1 if one is an error, 2 if they
cannot be printed.)",
      {CommandOption::Text("--models", "FILE",
                           "a file with the <TreeNodesModel> of the robot's node types, as "
                           "WriteModels of bt_core/engine/compile/models.h writes it. Without it, "
                           "node types that are not built in are not checked"),
       PluginOption(),
       CommandOption::Flag("--json",
                           "problems as an array of {file, line, column, severity, message, hint} "
                           "on the standard output")}};
  return command;
}

int RunCheck(const Arguments& arguments) {
  const Options options = ParseOptions(CheckCommand(), arguments);
  if (options.exit) return *options.exit;
  const std::shared_ptr<Registry> registry = RegistryWithPlugins(options);
  if (!registry) return 2;
  const Diagnostics diagnostics = Check(options, registry);
  const std::vector<Diagnostic> sorted = Sorted(diagnostics);
  if (options.Has("--json")) {
    PrintJson(sorted);
  } else {
    for (const Diagnostic& diagnostic : Folded(sorted)) std::cerr << ToString(diagnostic) << "\n";
  }
  if (!std::cerr) return 2;  // nobody has read what is wrong
  return diagnostics.has_errors() ? 1 : 0;
}

}  // namespace coppice
