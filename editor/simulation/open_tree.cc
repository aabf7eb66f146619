#include "editor/simulation/open_tree.h"

#include <utility>

#include "bt_core/testing/stand_in.h"

namespace coppice::editor {

std::shared_ptr<const Program> CompileOpenTree(OpenProject& files, const std::string& path,
                                               const std::string& tree_id, const Project* models,
                                               Diagnostics& diagnostics) {
  std::optional<LinkedProject> linked = ReadLinked(files, path, diagnostics);
  if (!linked) return nullptr;
  const auto registry = ScenarioRegistry(linked->project, models);
  return Compile(std::make_shared<const Project>(std::move(linked->project)), registry, diagnostics,
                 tree_id.empty() ? linked->main_tree : tree_id);
}

}  // namespace coppice::editor
