#include "editor/canvas/layout/wrapped_tree.h"

#include <algorithm>

#include "editor/canvas/layout/packed_rows.h"

namespace coppice::editor {
namespace {

constexpr int kTrials = 12;  // for the breadth of the rows

// Breadth divided by depth that broken rows shall have together.
constexpr float kShapeDown = 1.6F;
constexpr float kShapeAcross = 0.625F;

Point Flipped(Point p) { return {p.y, p.x}; }

// Top to bottom; the caller turns it.
class Wrapper {
 public:
  Wrapper(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
          const RowOptions& options, float shape)
      : ends_(ends), sizes_(sizes), options_(options), shape_(shape) {
    branch_.resize(sizes.size());
    at_.resize(sizes.size());
  }

  // Where each node is below its parent.
  std::vector<Point> Run() {
    SetLimits();
    for (auto i = static_cast<std::uint32_t>(sizes_.size()); i-- > 0;) Measure(i);
    return std::move(at_);
  }

 private:
  // Rows stand further to the right the deeper they are.
  void SetLimits() {
    limits_.assign(sizes_.size(), options_.limit - options_.indent);
    for (std::uint32_t i = 0; i < sizes_.size(); ++i) {
      for (std::uint32_t c = i + 1; c < ends_[i]; c = ends_[c]) {
        limits_[c] = limits_[i] - options_.indent;
      }
    }
  }

  // The room of the branch of a node, whose children have theirs.
  void Measure(std::uint32_t i) {
    branch_[i] = sizes_[i];
    if (ends_[i] == i + 1) return;
    const Point rows = BreakRows(i);
    branch_[i].x = std::max(sizes_[i].x, options_.indent + rows.x);
    branch_[i].y += options_.level_gap + rows.y;
  }

  // Puts the children into one row, or into rows of the breadth that gives them their shape.
  Point BreakRows(std::uint32_t i) {
    float narrow = 0;
    float wide = -options_.sibling_gap;
    for (std::uint32_t c = i + 1; c < ends_[i]; c = ends_[c]) {
      narrow = std::max(narrow, branch_[c].x);
      wide += branch_[c].x + options_.sibling_gap;
    }
    wide = std::max(narrow, std::min(wide, limits_[i]));
    if (wide <= options_.breadth) return FillRows(i, wide);
    for (int trial = 0; trial < kTrials; ++trial) {
      const float middle = (narrow + wide) / 2;
      const Point room = FillRows(i, middle);
      (room.x < shape_ * room.y ? narrow : wide) = middle;
    }
    return FillRows(i, wide);
  }

  // As many in each row as fit. Returns the room of all rows.
  Point FillRows(std::uint32_t i, float breadth) {
    Point room;
    Point row;  // its breadth and depth so far
    const float top = sizes_[i].y + options_.level_gap;
    for (std::uint32_t c = i + 1; c < ends_[i]; c = ends_[c]) {
      if (row.x > 0 && row.x + options_.sibling_gap + branch_[c].x > breadth + 0.01F) {
        room.y += row.y + options_.level_gap;
        row = {};
      }
      if (row.x > 0) row.x += options_.sibling_gap;
      at_[c] = {options_.indent + row.x, top + room.y};
      row.x += branch_[c].x;
      row.y = std::max(row.y, branch_[c].y);
      room.x = std::max(room.x, row.x);
    }
    room.y += row.y;
    return room;
  }

  const std::vector<std::uint32_t>& ends_;
  const std::vector<Point>& sizes_;
  const RowOptions options_;
  const float shape_;
  std::vector<Point> branch_;  // room of a whole branch
  std::vector<float> limits_;  // of the rows of a node
  std::vector<Point> at_;      // below the parent
};

}  // namespace

WrappedTree LayOutWrapped(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
                          const RowOptions& options) {
  if (sizes.empty()) return {};
  const bool sideways = options.orientation == Orientation::kLeftToRight;
  std::vector<Point> turned = sizes;
  if (sideways) std::transform(sizes.begin(), sizes.end(), turned.begin(), Flipped);
  const RowGaps gaps = {options.sibling_gap, options.level_gap, options.indent};
  std::vector<Point> at =
      options.packed ? PackRows(ends, turned, gaps, options.limit)
                     : Wrapper(ends, turned, options, sideways ? kShapeAcross : kShapeDown).Run();
  WrappedTree tree;
  tree.boxes.reserve(sizes.size());
  // Parents come first in preorder.
  for (std::uint32_t i = 0; i < sizes.size(); ++i) {
    tree.boxes.push_back({at[i], at[i] + turned[i]});
    for (std::uint32_t c = i + 1; c < ends[i]; c = ends[c]) at[c] = at[c] + at[i];
  }
  if (sideways) {
    for (Box& box : tree.boxes) box = {Flipped(box.min), Flipped(box.max)};
  }
  tree.bounds = tree.boxes[0];
  for (const Box& box : tree.boxes) tree.bounds = Union(tree.bounds, box);
  return tree;
}

}  // namespace coppice::editor
