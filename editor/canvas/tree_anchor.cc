// What holds still in a TreeView when the nodes get new places.
#include <algorithm>
#include <limits>

#include "editor/canvas/tree_view.h"

namespace coppice::editor {
namespace {

constexpr float kReach = 80;       // pixels from the mouse to a node that is meant with it
constexpr float kLeastMargin = 8;  // if a bar above the canvas has taken the rest

// What must be added to `at` for it to lie between the two.
float Into(float low, float high, float at) { return std::clamp(at, low, high) - at; }

Point Into(const Box& box, Point at) {
  return {Into(box.min.x, box.max.x, at.x), Into(box.min.y, box.max.y, at.y)};
}

float Squared(Point way) { return way.x * way.x + way.y * way.y; }

}  // namespace

Point TreeView::MouseInWorld() const { return camera.ToWorld(*mouse - canvas_.min); }

// Without what is being carried: that is where the mouse takes it.
std::uint32_t TreeView::Nearest(Point world, double now) const {
  std::uint32_t nearest = 0;
  float least = std::numeric_limits<float>::max();
  for (std::uint32_t k = 0; k < shown_.size(); ++k) {
    const auto& carried = gesture.drag.nodes;
    if (std::binary_search(carried.begin(), carried.end(), shown_[k])) {
      k = shown_ends_[k] - 1;
      continue;
    }
    const float distance = Squared(Into(BoxAt(k, now), world));
    if (distance > least) continue;
    least = distance;
    nearest = k;
  }
  return nearest;
}

bool TreeView::IsMouseOnNode() const {
  if (!mouse || shown_.empty()) return false;
  const Point at = MouseInWorld();
  return layout_.boxes[Nearest(at, kAtRest)].Contains(at);
}

// What is below the mouse or close to it, else `wanted`, else what is in the middle.
std::uint32_t TreeView::Anchor(std::uint32_t wanted, double now) const {
  if (shown_.empty()) return kNoSceneNode;
  const Point size = {canvas_.width(), canvas_.height()};
  const Point eyes = mouse ? MouseInWorld() : camera.ToWorld(size * 0.5F);
  const std::uint32_t nearest = Nearest(eyes, now);
  const float reach = kReach * screen_scale_ / camera.zoom;
  const bool is_near = mouse && Squared(Into(BoxAt(nearest, now), eyes)) <= reach * reach;
  if (is_near || wanted == kNoSceneNode || !gesture.drag.nodes.empty()) return shown_[nearest];
  const Box box = camera.ToScreen(BoxAt(ShownOf(wanted), now));
  const bool is_seen = size.x < 1 || box.Overlaps({{0, 0}, size});
  return is_seen ? wanted : shown_[nearest];
}

void TreeView::Relayout(std::uint32_t anchor, double now) {
  const Places before = PlacesAt(now);
  ListShown();
  LayOutShown();
  Move(before, anchor, now);
}

// The anchor does not move on the screen: what the layout moves it, the camera moves back, and
// where the boxes come from is shifted along. kNoSceneNode: everything is in its place at once.
void TreeView::Move(const Places& before, std::uint32_t anchor, double now) {
  from_.assign(shown_.size(), {});
  moved_at_ = kNeverMoved;
  if (anchor == kNoSceneNode || shown_.empty()) return;
  anchor = shown_[ShownOf(anchor)];
  while (!before.known[anchor] && anchor != 0) anchor = scene_->nodes[anchor].parent;
  if (!before.known[anchor]) return;
  const Box& was = before.at[anchor];
  const Box& is = layout_.boxes[ShownOf(anchor)];
  Point shift = is.min - was.min;
  if (mouse && was.Contains(MouseInWorld())) shift = shift + Into(is, MouseInWorld() + shift);
  const bool was_fitted = camera == fitted_;
  camera.offset = camera.offset - shift * camera.zoom;
  if (was_fitted) fitted_ = camera;  // it was not the user who moved it
  if (!animated) return;
  for (std::uint32_t k = 0; k < shown_.size(); ++k) {
    const std::uint32_t node = shown_[k];
    if (before.known[node]) {
      from_[k] = before.at[node].min + shift;
    } else {
      // A new box comes out of its parent.
      from_[k] = k == 0 ? layout_.boxes[0].min : from_[shown_parents_[k]];
    }
  }
  moved_at_ = now;
}

// As little as needed. False if the tree would be cut.
bool TreeView::MoveIntoSight(Point canvas) {
  const Box box = camera.ToScreen(layout_.bounds);
  const float margin = kLeastMargin * screen_scale_;
  const Point least = Point{margin, margin} - box.min;
  const Point most = canvas - Point{margin, margin} - box.max;
  if (least.x > most.x || least.y > most.y) return false;
  camera.offset = camera.offset + Into({least, most}, {0, 0});
  return true;
}

}  // namespace coppice::editor
