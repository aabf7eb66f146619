// The selection of a TreeView.
#include <algorithm>
#include <utility>

#include "editor/canvas/tree_view.h"

namespace coppice::editor {

bool TreeView::IsSelected(std::uint32_t node) const {
  return std::binary_search(selection_.begin(), selection_.end(), node);
}

void TreeView::Select(std::uint32_t node) {
  if (node == kNoSceneNode) {
    SelectAll({});
  } else {
    SelectAll({node});
  }
}

void TreeView::ToggleSelected(std::uint32_t node) {
  std::vector<std::uint32_t> nodes = selection_;
  if (IsSelected(node)) {
    nodes.erase(std::find(nodes.begin(), nodes.end(), node));
  } else {
    nodes.push_back(node);
  }
  SelectAll(std::move(nodes));
}

void TreeView::SelectTo(std::uint32_t node) {
  if (selected_ == kNoSceneNode) return Select(node);
  const auto& all = scene_->nodes;
  const std::uint32_t first = std::min(node, selected_);
  const std::uint32_t last = std::max(node, selected_);
  std::vector<std::uint32_t> nodes = selection_;
  if (all[first].parent == all[last].parent) {
    for (std::uint32_t i = first; i <= last; i = all[i].end) nodes.push_back(i);
  } else {
    const std::uint32_t end = ShownOf(last);
    for (std::uint32_t k = ShownOf(first); k <= end; ++k) nodes.push_back(shown_[k]);
  }
  nodes.push_back(node);
  SelectAll(std::move(nodes));
}

void TreeView::SelectAll(std::vector<std::uint32_t> nodes) {
  selected_ = nodes.empty() ? kNoSceneNode : nodes.back();
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  selection_ = std::move(nodes);
  for (const std::uint32_t node : selection_) OpenAround(node);
}

// Opens what the node is hidden in. What is seen already is not moved smoothly: the user's eyes are
// on what comes up.
void TreeView::OpenAround(std::uint32_t node) {
  bool opened = false;
  for (std::uint32_t i = scene_->nodes[node].parent; i != kNoSceneNode;
       i = scene_->nodes[i].parent) {
    opened = opened || collapsed_[i];
    collapsed_[i] = false;
  }
  if (!opened) return;
  Relayout(Anchor(node, kAtRest), kAtRest);
  moved_at_ = kNeverMoved;
}

}  // namespace coppice::editor
