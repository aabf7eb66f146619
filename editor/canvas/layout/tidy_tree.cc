#include "editor/canvas/layout/tidy_tree.h"

#include <algorithm>
#include <limits>

namespace coppice::editor {
namespace {

constexpr std::uint32_t kNone = UINT32_MAX;

// The names are those of the paper: el and er are the extreme (lowest) nodes at the left and right
// border of a subtree, tl and tr the threads that continue a contour below a leaf, modifiers are
// relative to the parent. Breadth runs along x, depth along y.
struct Node {
  float w = 0, h = 0, x = 0, y = 0;
  float prelim = 0, mod = 0, shift = 0, change = 0;
  float msel = 0, mser = 0;  // sums of modifiers at the extreme nodes
  std::uint32_t el = kNone, er = kNone, tl = kNone, tr = kNone;
  std::uint32_t first_child = 0, child_count = 0;  // a range of Drawing::children
};

class Drawing {
 public:
  Drawing(const std::vector<std::uint32_t>& ends, std::vector<Node> nodes)
      : nodes_(std::move(nodes)) {
    LinkChildren(ends);
    for (std::size_t i = nodes_.size(); i-- > 0;)
      FirstWalk(nodes_[i], static_cast<std::uint32_t>(i));
    SecondWalk();
  }

  const std::vector<Node>& nodes() const { return nodes_; }
  std::size_t steps() const { return steps_; }

 private:
  // Lowest y of the right contour so far, with the sibling that it belongs to; a stack whose top is
  // the highest.
  struct Low {
    float y;
    std::uint32_t sibling;
  };

  void LinkChildren(const std::vector<std::uint32_t>& ends) {
    children_.reserve(nodes_.size());
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      nodes_[i].first_child = static_cast<std::uint32_t>(children_.size());
      for (std::uint32_t c = i + 1; c < ends[i]; c = ends[c]) {
        children_.push_back(c);
        ++nodes_[i].child_count;
        ++steps_;
      }
    }
  }

  Node& Child(const Node& t, std::uint32_t k) { return nodes_[children_[t.first_child + k]]; }
  static float Bottom(const Node& t) { return t.y + t.h; }

  // Children come later in preorder, so walking backwards finds them all finished.
  void FirstWalk(Node& t, std::uint32_t self) {
    if (t.child_count == 0) {
      t.el = t.er = self;
      return;
    }
    lows_.clear();
    PushLow(Bottom(nodes_[Child(t, 0).el]), 0);
    for (std::uint32_t i = 1; i < t.child_count; ++i) {
      const float bottom = Bottom(nodes_[Child(t, i).er]);
      Separate(t, i);
      PushLow(bottom, i);
    }
    const Node& first = Child(t, 0);
    const Node& last = Child(t, t.child_count - 1);
    const float first_center = first.prelim + first.mod + first.w / 2;
    const float last_center = last.prelim + last.mod + last.w / 2;
    t.prelim = (first_center + last_center) / 2 - t.w / 2;
    t.el = first.el;
    t.msel = first.msel;
    t.er = last.er;
    t.mser = last.mser;
  }

  void PushLow(float y, std::uint32_t sibling) {
    while (!lows_.empty() && y >= lows_.back().y) {
      lows_.pop_back();
      ++steps_;
    }
    lows_.push_back({y, sibling});
  }

  // Moves child i to the right until its left contour clears the right contour of its left
  // siblings.
  void Separate(Node& t, std::uint32_t i) {
    std::uint32_t right = children_[t.first_child + i - 1];
    std::uint32_t left = children_[t.first_child + i];
    float right_sum = nodes_[right].mod;
    float left_sum = nodes_[left].mod;
    std::size_t low = lows_.size() - 1;
    while (right != kNone && left != kNone) {
      ++steps_;
      const Node& r = nodes_[right];
      const Node& l = nodes_[left];
      if (low > 0 && Bottom(r) > lows_[low].y) --low;
      const float distance = right_sum + r.prelim + r.w - (left_sum + l.prelim);
      if (distance > 0) {
        left_sum += distance;
        MoveSubtree(t, i, lows_[low].sibling, distance);
      }
      const float right_bottom = Bottom(r);
      const float left_bottom = Bottom(l);
      if (right_bottom <= left_bottom) {
        right = r.child_count ? children_[r.first_child + r.child_count - 1] : r.tr;
        if (right != kNone) right_sum += nodes_[right].mod;
      }
      if (right_bottom >= left_bottom) {
        left = l.child_count ? children_[l.first_child] : l.tl;
        if (left != kNone) left_sum += nodes_[left].mod;
      }
    }
    if (right == kNone && left != kNone) SetLeftThread(t, i, left, left_sum);
    if (right != kNone && left == kNone) SetRightThread(t, i, right, right_sum);
  }

  void MoveSubtree(const Node& t, std::uint32_t i, std::uint32_t sibling, float distance) {
    Node& moved = Child(t, i);
    moved.mod += distance;
    moved.msel += distance;
    moved.mser += distance;
    if (sibling == i - 1) return;  // nothing stands between them
    const float part = distance / static_cast<float>(i - sibling);
    Child(t, sibling + 1).shift += part;
    moved.shift -= part;
    moved.change -= distance - part;
  }

  void SetLeftThread(const Node& t, std::uint32_t i, std::uint32_t next, float sum) {
    Node& first = Child(t, 0);
    Node& extreme = nodes_[first.el];
    extreme.tl = next;
    const float difference = sum - nodes_[next].mod - first.msel;
    extreme.mod += difference;
    extreme.prelim -= difference;
    first.el = Child(t, i).el;
    first.msel = Child(t, i).msel;
  }

  void SetRightThread(const Node& t, std::uint32_t i, std::uint32_t next, float sum) {
    Node& moved = Child(t, i);
    Node& extreme = nodes_[moved.er];
    extreme.tr = next;
    const float difference = sum - nodes_[next].mod - moved.mser;
    extreme.mod += difference;
    extreme.prelim -= difference;
    moved.er = Child(t, i - 1).er;
    moved.mser = Child(t, i - 1).mser;
  }

  // Turns relative into absolute positions. Parents come first in preorder.
  void SecondWalk() {
    std::vector<float> sum(nodes_.size(), 0);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      Node& t = nodes_[i];
      sum[i] += t.mod;
      t.x = t.prelim + sum[i];
      float shift = 0;
      float delta = 0;
      for (std::uint32_t k = 0; k < t.child_count; ++k) {
        ++steps_;
        Node& child = Child(t, k);
        shift += child.shift;
        delta += shift + child.change;
        child.mod += delta;
        sum[children_[t.first_child + k]] = sum[i];
      }
    }
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> children_;
  std::vector<Low> lows_;
  std::size_t steps_ = 0;
};

// Gives all nodes of a depth the room of the largest of them.
void AlignLayers(const std::vector<std::uint32_t>& ends, std::vector<Node>& nodes) {
  std::vector<std::uint32_t> depth(nodes.size(), 0);
  std::vector<float> room;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    for (std::uint32_t c = i + 1; c < ends[i]; c = ends[c]) depth[c] = depth[i] + 1;
    if (room.size() <= depth[i]) room.push_back(0);
    room[depth[i]] = std::max(room[depth[i]], nodes[i].h);
  }
  std::vector<float> start(room.size(), 0);
  for (std::size_t d = 1; d < room.size(); ++d) start[d] = start[d - 1] + room[d - 1];
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    nodes[i].y = start[depth[i]];
    nodes[i].h = room[depth[i]];
  }
}

// The boxes with their gaps; depth is known before breadth.
std::vector<Node> PaddedNodes(const std::vector<std::uint32_t>& ends,
                              const std::vector<Point>& sizes, const LayoutOptions& options) {
  const bool sideways = options.orientation == Orientation::kLeftToRight;
  std::vector<Node> nodes(sizes.size());
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    nodes[i].w = (sideways ? sizes[i].y : sizes[i].x) + options.sibling_gap;
    nodes[i].h = (sideways ? sizes[i].x : sizes[i].y) + options.level_gap;
    for (std::uint32_t c = i + 1; c < ends[i]; c = ends[c]) nodes[c].y = nodes[i].y + nodes[i].h;
  }
  if (options.layered) AlignLayers(ends, nodes);
  return nodes;
}

}  // namespace

TidyTree LayOut(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
                const LayoutOptions& options) {
  TidyTree result;
  if (sizes.empty()) return result;
  const Drawing drawing(ends, PaddedNodes(ends, sizes, options));
  result.steps = drawing.steps();
  float least = std::numeric_limits<float>::max();
  for (const Node& node : drawing.nodes()) least = std::min(least, node.x);
  const bool sideways = options.orientation == Orientation::kLeftToRight;
  result.boxes.reserve(sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const Node& node = drawing.nodes()[i];
    const Point at = sideways ? Point{node.y, node.x - least} : Point{node.x - least, node.y};
    result.boxes.push_back({at, at + sizes[i]});
  }
  result.bounds = result.boxes[0];
  for (const Box& box : result.boxes) result.bounds = Union(result.bounds, box);
  return result;
}

}  // namespace coppice::editor
