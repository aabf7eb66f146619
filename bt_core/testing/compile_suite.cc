#include <optional>
#include <utility>

#include "bt_core/engine/program.h"
#include "bt_core/model/project.h"
#include "bt_core/testing/scenario.h"
#include "bt_core/testing/stand_in.h"

namespace coppice {

std::shared_ptr<const Program> CompileSuite(const ScenarioSuite& suite, Project project,
                                            std::shared_ptr<Registry> known,
                                            Diagnostics& diagnostics) {
  std::optional<Project> models;
  if (!suite.models_file.empty()) {
    models = Project::FromFile(suite.models_file, diagnostics);
    if (!models) return nullptr;
  }
  const auto registry = ScenarioRegistry(project, models ? &*models : nullptr, std::move(known));
  return Compile(std::make_shared<const Project>(std::move(project)), registry, diagnostics,
                 suite.tree_id);
}

}  // namespace coppice
