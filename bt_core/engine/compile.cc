// Which tree to compile, and what can be said of a project before.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/engine/compiler.h"
#include "bt_core/engine/program.h"

namespace coppice {
namespace {

std::vector<std::string> TreeIds(const Project& project) {
  std::vector<std::string> ids;
  for (const auto& [id, definition] : project.trees()) ids.push_back(id);
  return ids;
}

void AskForMainTree(const Project& project, Problems& problems) {
  const Document& first = project.documents().front();
  std::string list;
  for (const std::string& id : TreeIds(project)) list += (list.empty() ? "" : ", ") + id;
  problems.Error(first, first.element(0).offset, "which tree is the main one?",
                 "give main_tree_to_execute; there are: " + list);
}

void ReportMissingTree(const Project& project, const std::string& id, Problems& problems) {
  const Document& first = project.documents().front();
  const Attribute* asked = first.FindAttribute(first.element(0), "main_tree_to_execute");
  const bool by_file = asked && asked->value == id;
  problems.Error(first, by_file ? asked->value_offset : first.element(0).offset,
                 "no tree " + Quoted(id), DidYouMean(id, TreeIds(project)));
}

// A tree and a node type of the same name could not be told apart in the compact form.
void CheckTreeNames(const Project& project, const Registry& registry, Problems& problems) {
  for (const auto& [id, definition] : project.trees()) {
    if (!registry.Find(id)) continue;
    const Document& document = project.documents()[definition.document];
    problems.Error(document, document.element(definition.element).offset,
                   "tree " + Quoted(id) + " has the name of a node type");
  }
}

}  // namespace

std::shared_ptr<const Program> Compile(std::shared_ptr<const Project> project,
                                       std::shared_ptr<const Registry> registry,
                                       Diagnostics& diagnostics, const std::string& tree_id) {
  Problems problems(diagnostics);
  const std::string id = tree_id.empty() ? project->main_tree() : tree_id;
  CheckTreeNames(*project, *registry, problems);
  const TreeDefinition* tree = project->Find(id);
  if (tree) {
    auto program = TreeCompiler(project, std::move(registry), problems).Run(id, *tree);
    return problems.has_errors() || project->has_errors() ? nullptr : program;
  }
  if (id.empty()) {
    AskForMainTree(*project, problems);
  } else {
    ReportMissingTree(*project, id, problems);
  }
  return nullptr;
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
