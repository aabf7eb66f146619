#include "editor/canvas/drop_target.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "editor/canvas/paint/edge_shape.h"

namespace coppice::editor {
namespace {

constexpr float kReach = 46;       // of an insertion bar, in pixels of the world
constexpr float kEdgeReach = 9;    // of a line
constexpr float kBar = 4;          // thickness of the bar
constexpr float kSidePart = 0.2F;  // of a node's width or height that means "beside it"
constexpr float kSideMost = 26;

// The bars before and behind the children of one node, and which of them is near.
struct Nearest {
  float distance = kReach;
  DropTarget target;
};

float DistanceToBox(const Box& box, Point point) {
  const float x = std::max({box.min.x - point.x, point.x - box.max.x, 0.0F});
  const float y = std::max({box.min.y - point.y, point.y - box.max.y, 0.0F});
  return std::hypot(x, y);
}

Box Grown(const Box& box, float pixels) {
  return {box.min - Point{pixels, pixels}, box.max + Point{pixels, pixels}};
}

class Finder {
 public:
  Finder(const TreeView& view, Point point, double now)
      : view_(view), nodes_(view.scene()->nodes), point_(point), now_(now) {}

  DropTarget Find() {
    if (view_.shown().empty()) return {};
    for (std::uint32_t k = 0; k < view_.shown().size();) {
      if (!Grown(view_.BranchBounds(k), kReach).Contains(point_)) {
        k = view_.shown_ends()[k];
        continue;
      }
      if (Box box = view_.BoxAt(k, now_); box.Contains(point_)) return Inside(k, box);
      LookAtChildren(k);
      ++k;
    }
    if (edge_) return *edge_;
    if (gap_.target.place != DropPlace::kNowhere) return gap_.target;
    return AboveRoot();
  }

 private:
  bool IsColumn(std::uint32_t k) const {
    const Link link = view_.LinkOf(k);
    return view_.orientation() == Orientation::kLeftToRight || link == Link::kTrunk;
  }

  // Not in the next row or column.
  static bool IsBeside(const Box& a, const Box& b, bool column) {
    return column ? a.min.x == b.min.x : a.min.y == b.min.y;
  }

  // The sides of a node mean the gaps beside it, its middle the node itself.
  DropTarget Inside(std::uint32_t k, const Box& box) const {
    const std::uint32_t node = view_.shown()[k];
    const DropTarget onto = {DropPlace::kNode, node, 0, box};
    const bool column = IsColumn(k);
    const float size = column ? box.height() : box.width();
    const float at = column ? point_.y - box.min.y : point_.x - box.min.x;
    const float side = std::min(size * kSidePart, kSideMost);
    if (k == 0) return onto;
    if (view_.LinkOf(k) == Link::kNone) {
      return point_.y - box.min.y < side ? DropTarget{DropPlace::kEdge, node, 0, box} : onto;
    }
    if (at >= side && at <= size - side) return onto;
    const bool behind = at > size / 2;
    return {DropPlace::kGap, nodes_[node].parent, nodes_[node].number - (behind ? 0U : 1U),
            BarOf(k, behind)};
  }

  // Beside a child; in the middle to its neighbour if there is one.
  Box BarOf(std::uint32_t k, bool behind) const {
    const Box box = view_.BoxAt(k, now_);
    const bool column = IsColumn(k);
    float at = column ? (behind ? box.max.y : box.min.y) : (behind ? box.max.x : box.min.x);
    const float away = behind ? 7.0F : -7.0F;
    const std::optional<std::uint32_t> next = Neighbour(k, behind);
    const Box other = next ? view_.BoxAt(*next, now_) : Box();
    if (next && IsColumn(*next) == column && IsBeside(box, other, column)) {
      at = (at + (column ? (behind ? other.min.y : other.max.y)
                         : (behind ? other.min.x : other.max.x))) /
           2;
    } else {
      at += away;
    }
    if (column) return {{box.min.x, at - kBar / 2}, {box.max.x, at + kBar / 2}};
    return {{at - kBar / 2, box.min.y - 4}, {at + kBar / 2, box.max.y + 4}};
  }

  std::optional<std::uint32_t> Neighbour(std::uint32_t k, bool behind) const {
    const std::uint32_t parent = view_.ShownParent(k);
    if (behind) {
      const std::uint32_t next = view_.shown_ends()[k];
      if (next < view_.shown_ends()[parent]) return next;
      return std::nullopt;
    }
    std::optional<std::uint32_t> before;
    for (std::uint32_t c = parent + 1; c < k; c = view_.shown_ends()[c]) before = c;
    return before;
  }

  void LookAtChildren(std::uint32_t k) {
    for (std::uint32_t c = k + 1; c < view_.shown_ends()[k]; c = view_.shown_ends()[c]) {
      const Box child = view_.BoxAt(c, now_);
      if (view_.LinkOf(c) == Link::kNone) continue;
      LookAtEdge(c);
      if (!Grown(child, kReach).Contains(point_)) continue;
      for (const bool behind : {false, true}) LookAtBar(c, behind);
    }
  }

  void LookAtEdge(std::uint32_t c) {
    if (edge_) return;
    const EdgeEnds ends = view_.EdgeTo(c, now_);
    if (!Union(ends.parent, ends.child).Contains(point_)) return;
    const EdgeShape edge = ShapeOfEdge(ends);
    if (DistanceTo(edge, point_) > kEdgeReach) return;
    const Box mark = Grown({edge.arrival, edge.arrival}, 6);
    edge_ = DropTarget{DropPlace::kEdge, view_.shown()[c], 0, mark};
  }

  void LookAtBar(std::uint32_t c, bool behind) {
    const SceneNode& node = nodes_[view_.shown()[c]];
    const Box bar = BarOf(c, behind);
    const float distance = DistanceToBox(bar, point_);
    if (distance >= gap_.distance) return;
    gap_ = {distance, {DropPlace::kGap, node.parent, node.number - (behind ? 0U : 1U), bar}};
  }

  DropTarget AboveRoot() const {
    const Box root = view_.BoxAt(0, now_);
    const Box above = {{root.min.x, root.min.y - kReach}, {root.max.x, root.min.y}};
    if (!above.Contains(point_)) return {};
    const Box bar = {{root.min.x, root.min.y - 10}, {root.max.x, root.min.y - 10 + kBar}};
    return {DropPlace::kEdge, view_.shown()[0], 0, bar};
  }

  const TreeView& view_;
  const std::vector<SceneNode>& nodes_;
  const Point point_;
  const double now_;
  Nearest gap_;
  std::optional<DropTarget> edge_;
};

}  // namespace

DropTarget FindDropTarget(const TreeView& view, Point world, double now) {
  return Finder(view, world, now).Find();
}

}  // namespace coppice::editor
