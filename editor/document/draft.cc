#include "editor/document/draft.h"

#include <algorithm>
#include <utility>

#include "bt_core/model/element_edits.h"

namespace coppice::editor {

Draft::Draft(Document document, const std::vector<ElementIndex>& selection)
    : document_(std::move(document)) {
  Select(selection);
}

bool Draft::Apply(const Edit& edit) {
  if (edit.empty()) return true;
  Diagnostics problems;
  std::optional<Document> after = document_.Edited(edit, problems);
  if (!after) {
    problems_.Append(problems);
    return false;
  }
  for (std::uint32_t& offset : offsets_) offset = MapOffset(edit, offset);
  document_ = *std::move(after);
  steps_.push_back(edit);
  return true;
}

bool Draft::Move(ElementIndex element, ElementIndex new_parent, std::uint32_t position) {
  const Edit edit = MoveElement(document_, element, new_parent, position);
  if (edit.empty()) return true;
  const std::uint32_t old = document_.element(element).offset;
  const std::uint32_t parent = MapOffset(edit, document_.element(new_parent).offset);
  const auto at = std::find(offsets_.begin(), offsets_.end(), old);
  if (!Apply(edit)) return false;
  if (at == offsets_.end()) return true;
  const ElementIndex moved = ChildAt(document_, document_.ElementAt(parent), position);
  if (moved != kNoElement) *at = document_.element(moved).offset;
  return true;
}

std::vector<ElementIndex> Draft::selection() const {
  std::vector<ElementIndex> elements;
  for (const std::uint32_t offset : offsets_) {
    const ElementIndex element = document_.ElementAt(offset);
    if (element != kNoElement && document_.element(element).offset == offset) {
      elements.push_back(element);
    }
  }
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  return elements;
}

void Draft::Select(const std::vector<ElementIndex>& elements) {
  offsets_.clear();
  for (const ElementIndex element : elements) {
    if (element < document_.elements().size()) {
      offsets_.push_back(document_.element(element).offset);
    }
  }
}

FileChange Draft::Finish(std::string path) && {
  FileChange change;
  for (const ElementIndex element : selection()) {
    change.selected.push_back(document_.element(element).offset);
  }
  change.path = std::move(path);
  change.steps = std::move(steps_);
  change.after = std::move(document_);
  return change;
}

std::vector<ElementIndex> Topmost(const Document& document, std::vector<ElementIndex> elements) {
  std::sort(elements.begin(), elements.end());
  std::vector<ElementIndex> top;
  for (const ElementIndex element : elements) {
    if (top.empty() || !LiesIn(document, element, top.back())) top.push_back(element);
  }
  return top;
}

std::uint32_t PositionOf(const Document& document, ElementIndex element) {
  std::uint32_t position = 0;
  for (ElementIndex i = document.element(document.element(element).parent).first_child;
       i != element; i = document.element(i).next_sibling) {
    ++position;
  }
  return position;
}

ElementIndex SiblingBefore(const Document& document, ElementIndex element) {
  ElementIndex before = kNoElement;
  for (ElementIndex i = document.element(document.element(element).parent).first_child;
       i != element; i = document.element(i).next_sibling) {
    before = i;
  }
  return before;
}

ElementIndex ChildAt(const Document& document, ElementIndex parent, std::uint32_t position) {
  ElementIndex child = kNoElement;
  for (ElementIndex i = document.element(parent).first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    child = i;
    if (position-- == 0) break;
  }
  return child;
}

bool LiesIn(const Document& document, ElementIndex inner, ElementIndex outer) {
  const Element& a = document.element(inner);
  const Element& b = document.element(outer);
  return a.offset >= b.offset && a.end <= b.end;
}

}  // namespace coppice::editor
