#include "editor/canvas/tree_view.h"

#include <algorithm>
#include <map>
#include <utility>

namespace coppice::editor {
namespace {

constexpr double kMoveSeconds = 0.15;
constexpr float kChipRow = 20;
constexpr float kMargin = 24;  // around a fitted tree, on the screen
constexpr float kLeastZoom = 0.0005F;
constexpr float kLargestZoom = 3;

float EaseOut(double t) {
  const auto rest = static_cast<float>(1 - std::clamp(t, 0.0, 1.0));
  return 1 - rest * rest * rest;
}

}  // namespace

void TreeView::SetScene(std::shared_ptr<const Scene> scene, std::vector<Point> sizes, double now) {
  std::set<std::string> closed;
  std::string selected;
  for (std::uint32_t i = 0; scene_ && i < scene_->nodes.size(); ++i) {
    if (collapsed_[i]) closed.insert(scene_->nodes[i].path);
    if (i == selected_) selected = scene_->nodes[i].path;
  }
  scene_ = std::move(scene);
  sizes_ = std::move(sizes);
  collapsed_.assign(scene_->nodes.size(), false);
  for (std::uint32_t i = 0; i < scene_->nodes.size() && !closed.empty(); ++i) {
    collapsed_[i] = closed.count(scene_->nodes[i].path) > 0 && scene_->HasChildren(i);
  }
  selected_ = selected.empty() ? kNoNode : scene_->FindPath(selected);
  shown_.clear();
  Relayout(kNoNode, now);
}

void TreeView::SetOrientation(Orientation orientation, double now) {
  if (orientation == orientation_) return;
  orientation_ = orientation;
  Relayout(selected_ == kNoNode ? 0 : selected_, now);
}

void TreeView::SetCollapsed(std::uint32_t node, bool collapsed, double now) {
  if (!scene_->HasChildren(node) || collapsed_[node] == collapsed) return;
  collapsed_[node] = collapsed;
  Relayout(node, now);
}

void TreeView::CollapseSubTrees(bool collapsed, double now) {
  for (std::uint32_t i = 0; i < scene_->nodes.size(); ++i) {
    if (scene_->nodes[i].shape == Shape::kSubTree) {
      collapsed_[i] = collapsed && scene_->HasChildren(i);
    }
  }
  Relayout(selected_ == kNoNode ? 0 : selected_, now);
}

void TreeView::Select(std::uint32_t node) {
  selected_ = node;
  bool opened = false;
  while (node != kNoNode && (node = scene_->nodes[node].parent) != kNoNode) {
    opened = opened || collapsed_[node];
    collapsed_[node] = false;
  }
  if (opened) Relayout(0, moved_at_);
}

std::uint32_t TreeView::ShownOf(std::uint32_t node) const {
  const auto after = std::upper_bound(shown_.begin(), shown_.end(), node);
  return static_cast<std::uint32_t>(after - shown_.begin()) - 1;
}

// The anchor does not move on the screen: what the layout moves it, the camera moves back, and
// where the boxes come from is shifted along.
void TreeView::Relayout(std::uint32_t anchor, double now) {
  std::map<std::uint32_t, Point> before;
  const bool animate = !shown_.empty() && anchor != kNoNode;
  for (std::uint32_t k = 0; animate && k < shown_.size(); ++k) {
    before[shown_[k]] = BoxAt(k, now).min;
  }
  if (animate) anchor = shown_[ShownOf(anchor)];

  shown_.clear();
  shown_ends_.clear();
  std::vector<Point> sizes;
  const std::uint32_t count = scene_->nodes.empty() ? 0 : scene_->nodes[0].end;
  for (std::uint32_t i = 0; i < count; i = collapsed_[i] ? scene_->nodes[i].end : i + 1) {
    shown_.push_back(i);
    sizes.push_back(sizes_[i] + Point{0, collapsed_[i] ? kChipRow : 0});
  }
  for (const std::uint32_t node : shown_) {
    const auto end = std::lower_bound(shown_.begin(), shown_.end(), scene_->nodes[node].end);
    shown_ends_.push_back(static_cast<std::uint32_t>(end - shown_.begin()));
  }
  LayoutOptions options;
  options.orientation = orientation_;
  if (orientation_ == Orientation::kLeftToRight) options = {orientation_, 14, 56};
  layout_ = LayOut(shown_ends_, sizes, options);

  branches_ = layout_.boxes;
  for (auto k = static_cast<std::uint32_t>(shown_.size()); k-- > 1;) {
    const std::uint32_t parent = ShownOf(scene_->nodes[shown_[k]].parent);
    branches_[parent] = Union(branches_[parent], branches_[k]);
  }

  from_.assign(shown_.size(), {});
  if (!animate || before.count(anchor) == 0) {
    moved_at_ = -1e9;
    return;
  }
  const Point shift = layout_.boxes[ShownOf(anchor)].min - before[anchor];
  for (std::uint32_t k = 0; k < shown_.size(); ++k) {
    std::uint32_t origin = shown_[k];  // a new box comes out of the nearest old one
    while (before.count(origin) == 0) origin = scene_->nodes[origin].parent;
    from_[k] = before[origin] + shift;
  }
  camera.offset = camera.offset - shift * camera.zoom;
  moved_at_ = now;
}

Box TreeView::BoxAt(std::uint32_t k, double now) const {
  const Box& rest = layout_.boxes[k];
  if (!IsMoving(now)) return rest;
  const float t = EaseOut((now - moved_at_) / kMoveSeconds);
  const Point min = from_[k] + (rest.min - from_[k]) * t;
  return {min, min + (rest.max - rest.min)};
}

bool TreeView::IsMoving(double now) const { return now < moved_at_ + kMoveSeconds; }

void TreeView::FitAll(Point canvas) {
  if (shown_.empty() || canvas.x < 1 || canvas.y < 1) return;
  Fit(layout_.bounds, canvas, 1);
  needs_fit = false;
}

void TreeView::FitSelection(Point canvas) {
  if (selected_ == kNoNode) return;
  Fit(branches_[ShownOf(selected_)], canvas, 1.4F);
}

void TreeView::Fit(const Box& box, Point canvas, float largest_zoom) {
  const float across = std::max(canvas.x - 2 * kMargin, 1.0F) / std::max(box.width(), 1.0F);
  const float down = std::max(canvas.y - 2 * kMargin, 1.0F) / std::max(box.height(), 1.0F);
  camera.zoom = std::clamp(std::min(across, down), kLeastZoom, largest_zoom);
  camera.offset = canvas * 0.5F - box.center() * camera.zoom;
}

void TreeView::ZoomAt(Point screen, float factor) {
  const Point world = camera.ToWorld(screen);
  camera.zoom = std::clamp(camera.zoom * factor, kLeastZoom, kLargestZoom);
  camera.offset = screen - world * camera.zoom;
}

void TreeView::Reveal(Point canvas) {
  if (selected_ == kNoNode) return;
  const Box box = camera.ToScreen(layout_.boxes[ShownOf(selected_)]);
  const auto correction = [](float low, float high, float size) {
    if (low < kMargin) return kMargin - low;
    return high > size - kMargin ? std::max(size - kMargin - high, kMargin - low) : 0.0F;
  };
  camera.offset = camera.offset + Point{correction(box.min.x, box.max.x, canvas.x),
                                        correction(box.min.y, box.max.y, canvas.y)};
}

}  // namespace coppice::editor
