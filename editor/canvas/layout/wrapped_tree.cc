#include "editor/canvas/layout/wrapped_tree.h"

#include <algorithm>
#include <utility>

namespace coppice::editor {
namespace {

constexpr float kIndent = 34;  // of the rows: room for the line to them
constexpr int kTrials = 12;    // for the breadth of the rows
constexpr std::uint32_t kNone = UINT32_MAX;

// When a branch is wrapped. Breadth is the direction of siblings, depth that of generations.
struct Limits {
  float breadth;  // pixels; what is narrower is left alone
  float flat;     // breadth divided by depth, from which on it is wrapped
  float wished;   // the same of what is wrapped
};
constexpr Limits kDown = {2400, 3.2F, 1.6F};
constexpr Limits kAcross = {1500, 1.25F, 0.625F};

Point Flipped(Point p) { return {p.y, p.x}; }

// Top to bottom; the caller turns it.
class Wrapper {
 public:
  Wrapper(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
          const LayoutOptions& options, const Limits& limits)
      : ends_(ends), sizes_(sizes), options_(options), limits_(limits) {
    options_.orientation = Orientation::kTopToBottom;
    branch_.resize(sizes.size());
    row_.assign(sizes.size(), 0);
    has_rows_.assign(sizes.size(), false);
    at_.resize(sizes.size());
    block_ = sizes;
  }

  WrappedTree Run() {
    const auto count = static_cast<std::uint32_t>(sizes_.size());
    for (std::uint32_t i = count; i-- > 0;) Measure(i);
    for (std::uint32_t i = count; i-- > 0;) {
      if (has_rows_[i]) PlaceRows(i);
    }
    Place({0}, {});
    return Collected();
  }

 private:
  // The room that the branch of a node takes at most.
  void Measure(std::uint32_t i) {
    Point room;
    std::uint32_t children = 0;
    for (std::uint32_t c = i + 1; c < ends_[i]; c = ends_[c], ++children) {
      room.x += branch_[c].x + (children > 0 ? options_.sibling_gap : 0);
      room.y = std::max(room.y, branch_[c].y);
    }
    if (children == 0) {
      branch_[i] = sizes_[i];
      return;
    }
    const float above = sizes_[i].y + options_.level_gap;
    const bool too_wide = room.x > limits_.breadth && room.x > limits_.flat * (above + room.y);
    if (children > 1 && too_wide) {
      room = BreakRows(i, room.x);
      has_rows_[i] = room.x > 0;
      room.x += kIndent;
    }
    branch_[i] = {std::max(sizes_[i].x, room.x), above + room.y};
  }

  // Finds the breadth of the rows that gives the wished shape, and puts the children into them.
  Point BreakRows(std::uint32_t i, float all) {
    float narrow = 0;
    float wide = all;
    for (std::uint32_t c = i + 1; c < ends_[i]; c = ends_[c])
      narrow = std::max(narrow, branch_[c].x);
    for (int trial = 0; trial < kTrials; ++trial) {
      const float middle = (narrow + wide) / 2;
      const Point room = FillRows(i, middle);
      (room.x < limits_.wished * room.y ? narrow : wide) = middle;
    }
    return FillRows(i, wide);
  }

  // As many in each row as fit. Returns the room of all rows.
  Point FillRows(std::uint32_t i, float breadth) {
    Point room;
    Point row;  // its breadth and depth so far
    std::uint32_t number = 0;
    for (std::uint32_t c = i + 1; c < ends_[i]; c = ends_[c]) {
      const float wanted = row.x + (row.x > 0 ? options_.sibling_gap : 0) + branch_[c].x;
      if (row.x > 0 && wanted > breadth) {
        room.y += row.y + options_.level_gap;
        row = {};
        ++number;
      }
      row.x += (row.x > 0 ? options_.sibling_gap : 0) + branch_[c].x;
      row.y = std::max(row.y, branch_[c].y);
      room.x = std::max(room.x, row.x);
      row_[c] = number;
    }
    room.y += row.y;
    return room;
  }

  // Inner nodes with rows are finished: they are single boxes here.
  void PlaceRows(std::uint32_t i) {
    Point corner = {kIndent, sizes_[i].y + options_.level_gap};
    Point block = sizes_[i];
    std::vector<std::uint32_t> row;
    for (std::uint32_t c = i + 1; c < ends_[i]; c = ends_[c]) {
      row.push_back(c);
      const bool is_last = ends_[c] == ends_[i] || row_[ends_[c]] != row_[c];
      if (!is_last) continue;
      const Point size = Place(row, corner);
      block = {std::max(block.x, corner.x + size.x), corner.y + size.y};
      corner.y = block.y + options_.level_gap;
      row.clear();
    }
    block_[i] = block;
  }

  // Lays out branches side by side, as if they had a parent. Returns how large they are together.
  Point Place(const std::vector<std::uint32_t>& branches, Point corner) {
    nodes_.assign(1, kNone);
    local_ends_.assign(1, 0);
    local_sizes_.assign(1, {});
    for (const std::uint32_t branch : branches) Collect(branch);
    local_ends_[0] = static_cast<std::uint32_t>(nodes_.size());
    const TidyTree tidy = LayOut(local_ends_, local_sizes_, options_);
    Box all = tidy.boxes[1];
    for (std::size_t k = 1; k < nodes_.size(); ++k) all = Union(all, tidy.boxes[k]);
    for (std::size_t k = 1; k < nodes_.size(); ++k) {
      at_[nodes_[k]] = corner + tidy.boxes[k].min - all.min;
    }
    return all.max - all.min;
  }

  void Collect(std::uint32_t branch) {
    std::vector<std::uint32_t> open;  // numbers in nodes_ of the nodes above
    for (std::uint32_t i = branch; i < ends_[branch]; i = has_rows_[i] ? ends_[i] : i + 1) {
      const auto k = static_cast<std::uint32_t>(nodes_.size());
      while (!open.empty() && ends_[nodes_[open.back()]] <= i) {
        local_ends_[open.back()] = k;
        open.pop_back();
      }
      nodes_.push_back(i);
      local_sizes_.push_back(block_[i]);
      local_ends_.push_back(k + 1);
      open.push_back(k);
    }
    for (const std::uint32_t k : open) local_ends_[k] = static_cast<std::uint32_t>(nodes_.size());
  }

  // Positions in a row are those below the node of the row.
  WrappedTree Collected() {
    WrappedTree result;
    std::vector<std::uint32_t> owner(sizes_.size(), kNone);
    for (std::uint32_t i = 0; i < sizes_.size(); ++i) {
      if (owner[i] != kNone) at_[i] = at_[i] + at_[owner[i]];
      const std::uint32_t below = has_rows_[i] ? i : owner[i];
      for (std::uint32_t c = i + 1; c < ends_[i]; c = ends_[c]) owner[c] = below;
      result.boxes.push_back({at_[i], at_[i] + sizes_[i]});
    }
    result.has_rows = std::move(has_rows_);
    return result;
  }

  const std::vector<std::uint32_t>& ends_;
  const std::vector<Point>& sizes_;
  LayoutOptions options_;
  const Limits limits_;
  std::vector<Point> branch_;  // room of a whole branch
  std::vector<std::uint32_t> row_;
  std::vector<bool> has_rows_;
  std::vector<Point> block_;  // what is laid out as one box: a node, or one with its rows
  std::vector<Point> at_;
  std::vector<std::uint32_t> nodes_, local_ends_;  // of what is being placed
  std::vector<Point> local_sizes_;
};

}  // namespace

WrappedTree LayOutWrapped(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
                          const LayoutOptions& options) {
  if (sizes.empty()) return {};
  const bool sideways = options.orientation == Orientation::kLeftToRight;
  std::vector<Point> turned = sizes;
  if (sideways) std::transform(sizes.begin(), sizes.end(), turned.begin(), Flipped);
  Limits limits = sideways ? kAcross : kDown;
  if (options.breadth > 0) limits.breadth = options.breadth;
  WrappedTree tree = Wrapper(ends, turned, options, limits).Run();
  if (sideways) {
    for (Box& box : tree.boxes) box = {Flipped(box.min), Flipped(box.max)};
  }
  tree.bounds = tree.boxes[0];
  for (const Box& box : tree.boxes) tree.bounds = Union(tree.bounds, box);
  return tree;
}

}  // namespace coppice::editor
