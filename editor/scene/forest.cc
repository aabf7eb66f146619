#include "editor/scene/forest.h"

#include <optional>
#include <utility>

namespace coppice::editor {

Forest Forest::FromFile(const std::string& path, Diagnostics& diagnostics,
                        const DocumentReader& read) {
  Forest forest;
  std::optional<Project> project = Project::FromFiles({path}, diagnostics, {}, read);
  if (!project) return forest;
  forest.project_ = std::make_shared<const Project>(*std::move(project));
  for (const Document& document : forest.project_->documents()) {
    forest.documents_.push_back(&document);
  }
  for (std::uint32_t i = 0; i < forest.documents_.size(); ++i) forest.AddTreesOf(i);
  forest.ChooseMain(forest.project_->main_tree());
  return forest;
}

Forest Forest::FromRobot(std::string text, const std::string& source, Diagnostics& diagnostics) {
  Forest forest;
  std::optional<Document> document = Document::FromText(std::move(text), source, diagnostics);
  if (!document) return forest;
  forest.single_ = std::make_shared<const Document>(*std::move(document));
  forest.documents_.push_back(forest.single_.get());
  forest.AddTreesOf(0);
  forest.ChooseMain({});
  return forest;
}

void Forest::AddTreesOf(std::uint32_t number) {
  const Document& document = *documents_[number];
  for (ElementIndex i = document.element(0).first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    const Element& element = document.element(i);
    if (element.tag != "BehaviorTree") continue;
    trees_.push_back({std::string(document.AttributeValue(element, "ID")),
                      std::string(document.AttributeValue(element, "_fullpath")), number, i});
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
