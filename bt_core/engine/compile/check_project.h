// All problems of a project, also where only a robot has all node types.
//
//   Diagnostics diagnostics;
//   std::optional<Project> project = Project::FromFiles(files, diagnostics);
//   if (!project) return;
//   const auto shared = std::make_shared<const Project>(*std::move(project));
//   CheckProject(shared, registry, {}, diagnostics);
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_CHECK_PROJECT_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_CHECK_PROJECT_H_

#include <memory>

#include "bt_core/base/diagnostic.h"
#include "bt_core/engine/registry.h"
#include "bt_core/model/project.h"

namespace coppice {

struct CheckOptions {
  /// The registry has all node types: others are errors. Else types of well-known programs are
  /// known (shipped_models.h), others are a warning for each type, and the rest of the tree is
  /// checked; and where a model in the project contradicts the built-in
  /// node of the same name, the model counts, with a warning.
  bool all_types_known = false;
};

/// Compiles every tree, those that are used as SubTrees inside of the trees that use them, and says
/// each problem once. A SubTree whose tree is not in the project is a warning.
void CheckProject(const std::shared_ptr<const Project>& project,
                  const std::shared_ptr<const Registry>& registry, const CheckOptions& options,
                  Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_CHECK_PROJECT_H_
