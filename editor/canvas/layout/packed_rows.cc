#include "editor/canvas/layout/packed_rows.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace coppice::editor {
namespace {

constexpr int kShapes = 24;  // of a branch, at most
constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr float kLittle = 0.01F;  // what sums of lengths are wrong by

struct Placed {
  Point at;               // below the parent
  std::size_t shape = 0;  // of the child
};

struct BranchShape {
  Point room;
  std::vector<Placed> children;
};

class Packer {
 public:
  Packer(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
         const RowGaps& gaps, float limit)
      : ends_(ends), sizes_(sizes), gaps_(gaps), shapes_(sizes.size()) {
    limits_.assign(sizes.size(), limit - gaps.indent);
    for (std::uint32_t i = 0; i < sizes.size(); ++i) {
      for (std::uint32_t c = i + 1; c < ends[i]; c = ends[c]) limits_[c] = limits_[i] - gaps.indent;
    }
  }

  std::vector<Point> Run() {
    for (auto i = static_cast<std::uint32_t>(sizes_.size()); i-- > 0;) Measure(i);
    std::vector<Point> at(sizes_.size());
    std::vector<std::size_t> chosen(sizes_.size());
    chosen[0] = shapes_[0].size() - 1;
    for (std::uint32_t i = 0; i < sizes_.size(); ++i) {
      auto placed = shapes_[i][chosen[i]].children.begin();
      for (std::uint32_t c = i + 1; c < ends_[i]; c = ends_[c], ++placed) {
        at[c] = placed->at;
        chosen[c] = placed->shape;
      }
    }
    return at;
  }

 private:
  // Shapes by rising breadth and falling depth, of a node whose children have theirs.
  void Measure(std::uint32_t i) {
    children_.clear();
    float narrow = 0;
    float wide = -gaps_.sibling;
    for (std::uint32_t c = i + 1; c < ends_[i]; c = ends_[c]) {
      children_.push_back(c);
      narrow = std::max(narrow, shapes_[c].front().room.x);
      wide += shapes_[c].back().room.x + gaps_.sibling;
    }
    std::vector<BranchShape>& shapes = shapes_[i];
    if (children_.empty()) {
      shapes.push_back({sizes_[i], {}});
      return;
    }
    wide = std::max(narrow, std::min(wide, limits_[i]));
    std::vector<BranchShape> found;
    for (int trial = 0; trial < kShapes; ++trial) {
      const float part = static_cast<float>(trial) / (kShapes - 1);
      found.push_back(FillRows(i, narrow + (wide - narrow) * part));
      if (wide - narrow < 1) break;
    }
    std::stable_sort(found.begin(), found.end(), [](const BranchShape& a, const BranchShape& b) {
      return a.room.x < b.room.x;
    });
    for (BranchShape& shape : found) {
      if (shapes.empty() || shape.room.y < shapes.back().room.y - kLittle) {
        shapes.push_back(std::move(shape));
      }
    }
  }

  // The first shape of a branch that is not deeper.
  std::size_t Narrowest(std::uint32_t child, float depth) const {
    const std::vector<BranchShape>& shapes = shapes_[child];
    const auto fits = [depth](const BranchShape& shape) { return shape.room.y <= depth + kLittle; };
    return static_cast<std::size_t>(std::find_if(shapes.begin(), shapes.end(), fits) -
                                    shapes.begin());
  }

  // The least depth of a row with these children that is at least `depth`; kNever: it is too long.
  float DepthOfRow(std::size_t first, std::size_t end, float breadth, float depth) const {
    for (;;) {
      float length = -gaps_.sibling;
      float next = kNever;  // depth, with which some branch is narrower
      float least = depth;
      for (std::size_t k = first; k < end; ++k) {
        const std::vector<BranchShape>& shapes = shapes_[children_[k]];
        const std::size_t shape = std::min(Narrowest(children_[k], depth), shapes.size() - 1);
        least = std::max(least, shapes[shape].room.y);
        if (shape > 0) next = std::min(next, shapes[shape - 1].room.y);
        length += shapes[shape].room.x + gaps_.sibling;
      }
      if (least > depth) {
        depth = least;
        continue;
      }
      if (length <= breadth + kLittle) return depth;
      if (next == kNever) return kNever;
      depth = next;
    }
  }

  // The children in rows of that breadth that are the least deep together.
  BranchShape FillRows(std::uint32_t i, float breadth) {
    const std::size_t count = children_.size();
    std::vector<float> depth(count + 1, kNever);  // of rows with the first so many
    std::vector<float> row(count + 1, 0);         // of the last of them
    std::vector<std::size_t> begin(count + 1, 0);
    depth[0] = 0;
    for (std::size_t first = 0; first < count; ++first) {
      const float above = depth[first] + (first > 0 ? gaps_.level : 0);
      float deep = 0;
      for (std::size_t end = first + 1; end <= count; ++end) {
        deep = DepthOfRow(first, end, breadth, deep);
        if (deep == kNever) break;
        if (above + deep >= depth[end] - kLittle) continue;
        depth[end] = above + deep;
        row[end] = deep;
        begin[end] = first;
      }
    }
    std::vector<std::pair<std::size_t, std::size_t>> rows;
    for (std::size_t end = count; end > 0; end = begin[end]) rows.emplace_back(begin[end], end);
    std::reverse(rows.begin(), rows.end());
    BranchShape shape;
    float top = sizes_[i].y + gaps_.level;
    for (const auto& [first, end] : rows) {
      float left = gaps_.indent;
      for (std::size_t k = first; k < end; ++k) {
        const std::size_t narrowest = Narrowest(children_[k], row[end]);
        shape.children.push_back({{left, top}, narrowest});
        left += shapes_[children_[k]][narrowest].room.x + gaps_.sibling;
      }
      shape.room.x = std::max(shape.room.x, left - gaps_.sibling);
      top += row[end] + gaps_.level;
    }
    shape.room = {std::max(shape.room.x, sizes_[i].x), top - gaps_.level};
    return shape;
  }

  const std::vector<std::uint32_t>& ends_;
  const std::vector<Point>& sizes_;
  const RowGaps gaps_;
  std::vector<std::vector<BranchShape>> shapes_;  // of each branch
  std::vector<float> limits_;                     // of the rows of a node
  std::vector<std::uint32_t> children_;           // of the node that is measured
};

}  // namespace

std::vector<Point> PackRows(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
                            const RowGaps& gaps, float limit) {
  return sizes.empty() ? std::vector<Point>() : Packer(ends, sizes, gaps, limit).Run();
}

}  // namespace coppice::editor
