#include "editor/scene/forest.h"

#include <optional>
#include <unordered_set>
#include <utility>

#include "bt_core/model/manifest.h"

namespace coppice::editor {

Forest Forest::FromFile(const std::string& path, Diagnostics& diagnostics) {
  std::optional<Project> project = Project::FromFile(path, diagnostics);
  if (!project) return {};
  const std::size_t documents = project->documents().size();
  const std::string main_tree = project->main_tree();
  return FromProject(*std::move(project), documents, main_tree);
}

Forest Forest::FromProject(Project project, std::size_t own_documents, std::string_view main_tree) {
  Forest forest;
  forest.project_ = std::make_shared<const Project>(std::move(project));
  for (const Document& document : forest.project_->documents()) {
    forest.documents_.push_back(&document);
  }
  forest.own_documents_ = own_documents;
  forest.AddAll();
  forest.ChooseMain(main_tree);
  return forest;
}

Forest Forest::FromDocuments(std::vector<Document> documents, std::string_view main_tree) {
  Forest forest;
  forest.texts_ = std::make_shared<const std::vector<Document>>(std::move(documents));
  for (const Document& document : *forest.texts_) forest.documents_.push_back(&document);
  forest.own_documents_ = forest.documents_.size();
  forest.AddAll();
  forest.ChooseMain(main_tree);
  return forest;
}

void Forest::AddAll() {
  for (std::uint32_t i = 0; i < documents_.size(); ++i) AddTreesOf(i);
  for (const Document* document : documents_) AddTagsOf(*document);
}

void Forest::AddTreesOf(std::uint32_t number) {
  const Document& document = *documents_[number];
  for (ElementIndex i = document.element(kRootElement).first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    const Element& element = document.element(i);
    if (element.tag != "BehaviorTree") continue;
    trees_.push_back({std::string(document.AttributeValue(element, "ID")),
                      std::string(document.AttributeValue(element, "_fullpath")), number, i});
  }
}

// Trees are large and tags are few: most elements have the tag of the one before.
void Forest::AddTagsOf(const Document& document) {
  std::unordered_set<std::string_view> known(used_tags_.begin(), used_tags_.end());
  std::string_view last;
  for (const Element& element : document.elements()) {
    if (element.tag == last || element.parent == kNoElement) continue;
    const std::string_view outer = document.element(element.parent).tag;
    if (outer == "TreeNodesModel" || outer == "MetadataFields" || CategoryFromTag(outer)) continue;
    last = element.tag;
    if (known.insert(last).second) used_tags_.push_back(last);
  }
}

void Forest::ChooseMain(std::string_view id) {
  main_tree_ = Find(id);
  if (main_tree_ < 0 && !trees_.empty()) main_tree_ = 0;
}

int Forest::Find(std::string_view id) const {
  for (std::size_t i = 0; i < trees_.size(); ++i) {
    if (trees_[i].id == id) return static_cast<int>(i);
  }
  return -1;
}

int Forest::Resolve(const Document& document, const Element& subtree) const {
  const Attribute* path = document.FindAttribute(subtree, "_fullpath");
  if (!path) return Find(document.AttributeValue(subtree, "ID"));
  for (std::size_t i = 0; i < trees_.size(); ++i) {
    if (trees_[i].instance_path == path->value) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace coppice::editor
