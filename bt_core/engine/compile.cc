// The public face of the compiler, declared in program.h.
#include <optional>
#include <string>
#include <utility>

#include "bt_core/engine/compile/compiler.h"
#include "bt_core/engine/compile/project_problems.h"
#include "bt_core/engine/program.h"

namespace coppice {

std::shared_ptr<const Program> Compile(std::shared_ptr<const Project> project,
                                       std::shared_ptr<const Registry> registry,
                                       Diagnostics& diagnostics, const std::string& tree_id,
                                       OuterKeys outer) {
  Problems problems(diagnostics);
  const std::string id = tree_id.empty() ? project->main_tree() : tree_id;
  CheckTreeNames(*project, *registry, problems);
  const TreeDefinition* tree = FindMainTree(*project, id, problems);
  if (!tree) return nullptr;
  auto program =
      TreeCompiler(project, std::move(registry), Tolerance{}, problems).Run(id, *tree, outer);
  return problems.has_errors() || project->has_errors() ? nullptr : program;
}

std::shared_ptr<const Program> CompileFile(const std::string& path,
                                           std::shared_ptr<const Registry> registry,
                                           Diagnostics& diagnostics, const std::string& tree_id) {
  std::optional<Project> project = Project::FromFile(path, diagnostics);
  if (!project) return nullptr;
  return Compile(std::make_shared<const Project>(*std::move(project)), std::move(registry),
                 diagnostics, tree_id);
}

}  // namespace coppice
