#include "editor/canvas/tree_layout.h"

#include <algorithm>
#include <utility>

namespace coppice::editor {
namespace {

constexpr float kStripGap = 2;       // between a decorator and what it lies on
constexpr float kColumnGap = 8;      // between the leaves of a column
constexpr float kColumnIndent = 16;  // room for the line along a column

// Nodes that are placed together, one below the other. They follow each other in preorder.
struct Block {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool is_column = false;

  float gap() const { return is_column ? kColumnGap : kStripGap; }
  float indent() const { return is_column ? kColumnIndent : 0; }
};

class Arranger {
 public:
  Arranger(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
           const std::vector<bool>& is_decorator, const LayoutStyle& style)
      : ends_(ends), sizes_(sizes), is_decorator_(is_decorator), style_(style) {
    result_.boxes.resize(sizes.size());
    result_.links.assign(sizes.size(), Link::kCurve);
    if (!sizes.empty()) result_.links[0] = Link::kNone;
  }

  TreeLayout Run() {
    MakeBlocks();
    LayoutOptions options;
    options.orientation = style_.orientation;
    options.layered = style_.layered;
    if (style_.orientation == Orientation::kLeftToRight) {
      options.sibling_gap = 14;
      options.level_gap = 56;
    }
    const TidyTree tidy = LayOut(BlockEnds(), BlockSizes(), options);
    for (std::size_t b = 0; b < blocks_.size(); ++b) Place(blocks_[b], tidy.boxes[b]);
    result_.bounds = tidy.bounds;
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
    starts_[first] = true;
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
  std::vector<Block> blocks_;
  std::vector<std::uint32_t> blocks_before_;  // blocks that begin before a node
  std::vector<bool> column_, starts_;         // in a column of leaves; the first of one
  TreeLayout result_;
};

}  // namespace

TreeLayout Arrange(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
                   const std::vector<bool>& is_decorator, const LayoutStyle& style) {
  return Arranger(ends, sizes, is_decorator, style).Run();
}

}  // namespace coppice::editor
