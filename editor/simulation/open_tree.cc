#include "editor/simulation/open_tree.h"

#include <utility>

#include "bt_core/testing/stand_in.h"

namespace coppice::editor {

std::optional<Project> ReadOpenProject(OpenProject& files, const std::string& path,
                                       Diagnostics& diagnostics) {
  const auto read = [&files](const std::string& wanted, Diagnostics& problems) {
    const EditedFile* edited = files.Open(wanted, problems);
    if (!edited) return std::optional<Document>();
    problems.Append(edited->problems);
    return edited->document;
  };
  return Project::FromFiles({path}, diagnostics, {}, read);
}

std::shared_ptr<const Program> CompileOpenTree(OpenProject& files, const std::string& path,
                                               const std::string& tree_id, const Project* models,
                                               Diagnostics& diagnostics) {
  std::optional<Project> project = ReadOpenProject(files, path, diagnostics);
  if (!project) return nullptr;
  const auto registry = ScenarioRegistry(*project, models);
  return Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics,
                 tree_id);
}

}  // namespace coppice::editor
