#include "bt_core/engine/compile/project_problems.h"

#include <vector>

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
  problems.Error(first, first.element(kRootElement).offset, "which tree is the main one?",
                 "give main_tree_to_execute; there are: " + list);
}

std::string PlaceOf(const Project& project, const NodeModel& model) {
  const Document& document = project.documents()[model.document];
  const SourceLocation where = document.Location(document.element(model.element).offset);
  return where.file + ":" + std::to_string(where.line);
}

// One without nodes is none; that was said where it stands.
bool IsWritten(const Project& project, const std::string& id) {
  for (const Document& document : project.documents()) {
    for (const Element& element : document.elements()) {
      if (element.tag == "BehaviorTree" && document.AttributeValue(element, "ID") == id)
        return true;
    }
  }
  return false;
}

// Points at main_tree_to_execute if that is what asks for it.
void ReportMissingTree(const Project& project, const std::string& id, Problems& problems) {
  const std::string hint = DidYouMean(id, TreeIds(project));
  for (const Document& document : project.documents()) {
    const Attribute* asked =
        document.FindAttribute(document.element(kRootElement), "main_tree_to_execute");
    if (!asked || asked->value != id) continue;
    problems.Error(document, asked->value_offset, "no tree " + Quoted(id), hint);
    return;
  }
  const Document& first = project.documents().front();
  problems.Error(first, first.element(kRootElement).offset, "no tree " + Quoted(id), hint);
}

}  // namespace

const TreeDefinition* FindMainTree(const Project& project, const std::string& id,
                                   Problems& problems) {
  const TreeDefinition* tree = project.Find(id);
  if (!tree && id.empty()) AskForMainTree(project, problems);
  if (!tree && !id.empty() && !IsWritten(project, id)) ReportMissingTree(project, id, problems);
  return tree;
}

void CheckTreeNames(const Project& project, const Registry& registry, Problems& problems) {
  for (const auto& [id, definition] : project.trees()) {
    const auto model = project.models().find(id);
    const bool is_described = model != project.models().end();
    if (!is_described && !registry.Find(id)) continue;
    const Document& document = project.documents()[definition.document];
    problems.Error(document, document.element(definition.element).offset,
                   "tree " + Quoted(id) + " has the name of a node type",
                   is_described ? "its model is at " + PlaceOf(project, model->second) : "");
  }
}

}  // namespace coppice
