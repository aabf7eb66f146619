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

class Arranger {
 public:
  Arranger(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
           const std::vector<bool>& is_decorator, const LayoutStyle& style, float breadth)
      : ends_(ends), sizes_(sizes), is_decorator_(is_decorator), style_(style), breadth_(breadth) {
    result_.boxes.resize(sizes.size());
    result_.links.assign(sizes.size(), Link::kCurve);
    result_.below_row.assign(sizes.size(), 0);
    if (!sizes.empty()) result_.links[0] = Link::kNone;
  }

  TreeLayout Run() {
    MakeBlocks();
    LayoutOptions options;
    options.orientation = style_.orientation;
    options.layered = style_.layered;
    options.breadth = breadth_;
    if (style_.orientation == Orientation::kLeftToRight) {
      options.sibling_gap = 14;
      options.level_gap = 56;
    }
    if (style_.wrapped && !style_.layered) {
      const std::vector<std::uint32_t> ends = BlockEnds();
      const WrappedTree wrapped = LayOutWrapped(ends, BlockSizes(), options);
      PlaceAll(wrapped.boxes, wrapped.bounds);
      LinkRows(ends, wrapped.has_rows);
    } else {
      const TidyTree tidy = LayOut(BlockEnds(), BlockSizes(), options);
      PlaceAll(tidy.boxes, tidy.bounds);
    }
    return std::move(result_);
  }

 private:
  void MakeBlocks() {
    const auto count = static_cast<std::uint32_t>(sizes_.size());
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
    return style_.compact && i > 0 && is_decorator_[i - 1] && ends_[i] == ends_[i - 1];
  }

  void MarkColumns() {
    column_.assign(sizes_.size(), false);
    starts_.assign(sizes_.size(), false);
    if (!style_.stacked || style_.orientation != Orientation::kTopToBottom) return;
    for (std::uint32_t i = 0; i < sizes_.size(); ++i) {
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
    const std::uint32_t high = style_.wrapped ? LeavesInAColumn(end - first) : end - first;
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
        size.x = std::max(size.x, sizes_[i].x);
        size.y += sizes_[i].y;
      }
      sizes.push_back(size + Point{block.indent(), 0});
    }
    return sizes;
  }

  void PlaceAll(const std::vector<Box>& boxes, const Box& bounds) {
    for (std::size_t b = 0; b < blocks_.size(); ++b) Place(blocks_[b], boxes[b]);
    result_.bounds = bounds;
  }

  void LinkRows(const std::vector<std::uint32_t>& ends, const std::vector<bool>& has_rows) {
    for (std::uint32_t b = 0; b < blocks_.size(); ++b) {
      if (!has_rows[b]) continue;
      for (std::uint32_t c = b + 1; c < ends[b]; c = ends[c]) LinkToRow(blocks_[c]);
    }
  }

  void LinkToRow(const Block& block) {
    if (!block.is_column) {
      result_.links[block.first] = Link::kRow;
      return;
    }
    for (std::uint32_t i = block.first; i < block.first + block.count; ++i) {
      result_.links[i] = Link::kRowColumn;
      result_.below_row[i] = result_.boxes[i].min.y - result_.boxes[block.first].min.y;
    }
  }

  void Place(const Block& block, const Box& box) {
    float y = box.min.y;
    for (std::uint32_t i = block.first; i < block.first + block.count; ++i) {
      result_.boxes[i] = {{box.min.x + block.indent(), y}, {box.max.x, y + sizes_[i].y}};
      y += sizes_[i].y + block.gap();
    }
  }

  const std::vector<std::uint32_t>& ends_;
  const std::vector<Point>& sizes_;
  const std::vector<bool>& is_decorator_;
  const LayoutStyle& style_;
  const float breadth_;
  std::vector<Block> blocks_;
  std::vector<std::uint32_t> blocks_before_;  // blocks that begin before a node
  std::vector<bool> column_, starts_;         // in a column of leaves; the first of one
  TreeLayout result_;
};

}  // namespace

TreeLayout Arrange(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
                   const std::vector<bool>& is_decorator, const LayoutStyle& style, float breadth) {
  return Arranger(ends, sizes, is_decorator, style, breadth).Run();
}

}  // namespace coppice::editor
