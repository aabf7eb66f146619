#include "bt_core/engine/compile/check_project.h"

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt_core/engine/compile/compiler.h"
#include "bt_core/engine/compile/model_registry.h"
#include "bt_core/engine/compile/project_problems.h"
#include "bt_core/engine/compile/shipped_models.h"

namespace coppice {
namespace {

using TreeIds = std::set<std::string_view>;

// The trees that others use: they are checked where they are used.
TreeIds UsedTrees(const Project& project) {
  TreeIds used;
  for (const Document& document : project.documents()) {
    for (const Element& element : document.elements()) {
      if (element.tag == "SubTree") used.insert(document.AttributeValue(element, "ID"));
    }
  }
  return used;
}

class Checker {
 public:
  Checker(const std::shared_ptr<const Project>& project,
          const std::shared_ptr<const Registry>& registry, Tolerance tolerance, Problems& problems)
      : project_(project), registry_(registry), tolerance_(tolerance), problems_(problems) {}

  void CheckAll() {
    const TreeIds used = UsedTrees(*project_);
    for (const auto& [id, tree] : project_->trees()) {
      if (used.count(id) == 0) Check(id, tree);
    }
    for (const auto& [id, tree] : project_->trees()) {  // those that use each other in a circle
      if (checked_.count(id) == 0) Check(id, tree);
    }
  }

 private:
  void Check(const std::string& id, const TreeDefinition& tree) {
    const auto program =
        TreeCompiler(project_, registry_, tolerance_, problems_, std::move(texts_)).Run(id, tree);
    texts_ = std::move(program->texts);  // for the next tree: to pack them takes long
    for (const TreeInstance& instance : program->trees) {
      checked_.insert(project_->trees().find(instance.id)->first);
    }
  }

  const std::shared_ptr<const Project>& project_;
  const std::shared_ptr<const Registry>& registry_;
  const Tolerance tolerance_;
  Problems& problems_;
  TreeIds checked_;
  std::vector<SourceText> texts_;
};

}  // namespace

void CheckProject(const std::shared_ptr<const Project>& project,
                  const std::shared_ptr<const Registry>& registry, const CheckOptions& options,
                  Diagnostics& diagnostics) {
  Problems problems(diagnostics);
  if (!project->main_tree().empty()) FindMainTree(*project, project->main_tree(), problems);
  auto known = std::make_shared<Registry>(*registry);
  if (!options.all_types_known) {
    RemoveContradicted(*project, *known, diagnostics);
    AddShippedModels(*project, *known, diagnostics);
  }
  CheckTreeNames(*project, *known, problems);
  Checker(project, known, {!options.all_types_known, true, true}, problems).CheckAll();
}

}  // namespace coppice
