#include "editor/canvas/layout/tree_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/canvas/layout/wrapped_tree.h"

namespace coppice::editor {
namespace {

constexpr float kStripGap = 2;            // between a decorator and what it lies on
constexpr float kColumnGap = 8;           // between the leaves of a column
constexpr float kColumnIndent = 16;       // room for the line along a column
constexpr std::uint32_t kFewLeaves = 20;  // stand in a single column

// Nodes that are placed together, one below the other. They follow each other in preorder.
struct Block {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool is_column = false;

  float gap() const { return is_column ? kColumnGap : kStripGap; }
  float indent() const { return is_column ? kColumnIndent : 0; }
};

// Of so many leaves; the columns together are somewhat wider than high.
std::uint32_t LeavesInAColumn(std::uint32_t leaves) {
  const auto wished = static_cast<std::uint32_t>(std::sqrt(3.5F * static_cast<float>(leaves)));
  const std::uint32_t most = std::max(kFewLeaves, wished);
  const std::uint32_t columns = (leaves + most - 1) / most;
  return (leaves + columns - 1) / columns;
}

// Gaps between boxes, along and across the direction in which the tree grows.
struct Gaps {
  float siblings, levels, indent;
};
constexpr Gaps kDown = {18, 38, 34};
constexpr Gaps kAcross = {14, 56, 34};
constexpr Gaps kNamesDown = {9, 19, 20};  // between names there is nothing to be read
constexpr Gaps kNamesAcross = {10, 30, 20};
constexpr Gaps kPackedDown = {9, 16, 14};  // as little as the lines need
constexpr Gaps kPackedAcross = {10, 24, 14};

Gaps GapsOf(const LayoutChoice& choice) {
  const bool down = choice.orientation == Orientation::kTopToBottom;
  if (choice.names_only && choice.packed) return down ? kPackedDown : kPackedAcross;
  if (choice.names_only) return down ? kNamesDown : kNamesAcross;
  return down ? kDown : kAcross;
}

class Arranger {
 public:
  Arranger(const MeasuredTree& tree, const LayoutStyle& style, const LayoutChoice& choice)
      : tree_(tree), ends_(tree.ends), style_(style), choice_(choice) {
    const std::size_t count = ends_.size();
    result_.boxes.resize(count);
    result_.links.assign(count, choice.rows > 0 ? Link::kRow : Link::kCurve);
    if (count > 0) result_.links[0] = Link::kNone;
  }

  TreeLayout Run() {
    MakeBlocks();
    const Gaps gaps = GapsOf(choice_);
    if (choice_.rows > 0) {
      const WrappedTree rows =
          LayOutWrapped(BlockEnds(), BlockSizes(),
                        {choice_.orientation, gaps.siblings, gaps.levels, gaps.indent, choice_.rows,
                         choice_.limit, choice_.packed});
      PlaceAll(rows.boxes, rows.bounds);
    } else {
      const TidyTree tidy =
          LayOut(BlockEnds(), BlockSizes(),
                 {choice_.orientation, gaps.siblings, gaps.levels, style_.layered});
      PlaceAll(tidy.boxes, tidy.bounds);
    }
    return std::move(result_);
  }

 private:
  void MakeBlocks() {
    const auto count = static_cast<std::uint32_t>(ends_.size());
    blocks_before_.resize(count + 1, 0);
    MarkColumns();
    for (std::uint32_t i = 0; i < count; ++i) {
      blocks_before_[i] = static_cast<std::uint32_t>(blocks_.size());
      const bool joins = i > 0 && (LiesUnderStrip(i) || (column_[i] && !starts_[i]));
      if (joins) {
        ++blocks_.back().count;
      } else {
        blocks_.push_back({i, 1, column_[i]});
      }
      if (LiesUnderStrip(i)) result_.links[i] = Link::kNone;
      if (column_[i]) result_.links[i] = Link::kTrunk;
    }
    blocks_before_[count] = static_cast<std::uint32_t>(blocks_.size());
  }

  // The only child of a decorator: the decorator is the node before it.
  bool LiesUnderStrip(std::uint32_t i) const {
    return (style_.compact || choice_.compact) && i > 0 && tree_.is_decorator[i - 1] &&
           ends_[i] == ends_[i - 1];
  }

  void MarkColumns() {
    column_.assign(ends_.size(), false);
    starts_.assign(ends_.size(), false);
    const bool down = choice_.orientation == Orientation::kTopToBottom;
    if (!style_.stacked || !down || choice_.rows > 0) return;
    for (std::uint32_t i = 0; i < ends_.size(); ++i) {
      std::uint32_t first = i + 1;
      for (std::uint32_t c = i + 1; c < ends_[i]; c = ends_[c]) {
        if (ends_[c] == c + 1) continue;
        MarkColumn(first, c);
        first = ends_[c];
      }
      MarkColumn(first, ends_[i]);
    }
  }

  // The nodes from `first` to `end` are leaves of one parent.
  void MarkColumn(std::uint32_t first, std::uint32_t end) {
    if (end <= first || end - first <= kMostLeavesInARow) return;
    const std::uint32_t high = LeavesInAColumn(end - first);
    for (std::uint32_t i = first; i < end; i += high) starts_[i] = true;
    std::fill(column_.begin() + first, column_.begin() + end, true);
  }

  std::vector<std::uint32_t> BlockEnds() const {
    std::vector<std::uint32_t> ends;
    ends.reserve(blocks_.size());
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const std::uint32_t end = blocks_before_[ends_[blocks_[b].first]];
      ends.push_back(blocks_[b].is_column ? static_cast<std::uint32_t>(b + 1) : end);
    }
    return ends;
  }

  std::vector<Point> BlockSizes() const {
    std::vector<Point> sizes;
    sizes.reserve(blocks_.size());
    for (const Block& block : blocks_) {
      Point size = {0, block.gap() * static_cast<float>(block.count - 1)};
      for (std::uint32_t i = block.first; i < block.first + block.count; ++i) {
        size.x = std::max(size.x, SizeOf(i).x);
        size.y += SizeOf(i).y;
      }
      sizes.push_back(size + Point{block.indent(), 0});
    }
    return sizes;
  }

  void PlaceAll(const std::vector<Box>& boxes, const Box& bounds) {
    for (std::size_t b = 0; b < blocks_.size(); ++b) Place(blocks_[b], boxes[b]);
    result_.bounds = bounds;
  }

  void Place(const Block& block, const Box& box) {
    float y = box.min.y;
    for (std::uint32_t i = block.first; i < block.first + block.count; ++i) {
      result_.boxes[i] = {{box.min.x + block.indent(), y}, {box.max.x, y + SizeOf(i).y}};
      y += SizeOf(i).y + block.gap();
    }
  }

  Point SizeOf(std::uint32_t i) const {
    return choice_.names_only ? tree_.sizes[i].name : tree_.sizes[i].full;
  }

  const MeasuredTree& tree_;
  const std::vector<std::uint32_t>& ends_;
  const LayoutStyle& style_;
  const LayoutChoice& choice_;
  std::vector<Block> blocks_;
  std::vector<std::uint32_t> blocks_before_;  // blocks that begin before a node
  std::vector<bool> column_, starts_;         // in a column of leaves; the first of one
  TreeLayout result_;
};

}  // namespace

TreeLayout Arrange(const MeasuredTree& tree, const LayoutStyle& style, const LayoutChoice& choice) {
  return Arranger(tree, style, choice).Run();
}

}  // namespace coppice::editor
