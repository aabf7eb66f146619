#include "editor/canvas/layout/layout_choice.h"

#include <algorithm>
#include <utility>

namespace coppice::editor {
namespace {

// Breadths from which on rows are broken, at zoom 1: what fits best is found by trying.
constexpr float kRows[] = {300, 400, 500, 650, 800, 1000, 1300, 1600, 2000, 2800};
constexpr std::size_t kMostToTry = 2000;  // nodes; larger trees cannot be read as a whole anyway

// Packing rows is work: for trees that can fill a canvas and be read.
constexpr std::size_t kMostToPack = 300;
constexpr int kPackings = 6;  // to find the largest

constexpr float kFarLarger = 1.25F;
constexpr float kLargeEnough = 0.8F;  // nobody turns a tree that has that zoom

class Chooser {
 public:
  Chooser(const MeasuredTree& tree, const LayoutStyle& style, Point canvas)
      : tree_(tree), style_(style), canvas_(canvas) {}

  ChosenLayout Choose() {
    if (tree_.ends.size() <= kMostToTry && FindReadable()) return std::move(best_);
    return Page();
  }

 private:
  bool FindReadable() {
    for (const bool names_only : {false, true}) {
      if (IsAllowed(names_only) && TryTidy(names_only)) return true;
    }
    if (!RowsAreAllowed()) return false;
    for (const bool compact : {false, true}) {
      for (const Orientation orientation : {Orientation::kTopToBottom, Orientation::kLeftToRight}) {
        if (IsAllowed(orientation) && TryRows(RowsOf(orientation, compact))) return true;
      }
    }
    if (tree_.ends.size() > kMostToPack) return false;
    for (const bool compact : {false, true}) {
      for (const Orientation orientation : {Orientation::kTopToBottom, Orientation::kLeftToRight}) {
        if (IsAllowed(orientation) && TryPacked(RowsOf(orientation, compact))) return true;
      }
    }
    return false;
  }

  // The largest that fits: by halving.
  bool TryPacked(LayoutChoice choice) {
    const float readable = Readable(choice);
    const float longest = choice.limit;
    choice.rows = longest;
    choice.packed = true;
    bool found = false;
    float low = readable;
    float high = 2 * readable;
    for (int trial = 0; trial < kPackings; ++trial) {
      const float zoom = trial == 0 ? low : (low + high) / 2;
      choice.limit = longest * readable / zoom;
      TreeLayout layout = Arrange(tree_, style_, choice);
      const bool fits = ZoomOf(layout.bounds) >= zoom;
      (fits ? low : high) = zoom;
      if (fits) best_ = {choice, std::move(layout), readable, true};
      found = found || fits;
      if (!found) break;
    }
    return found;
  }

  // The largest of those that can be read.
  bool TryRows(LayoutChoice choice) {
    float largest = 0;
    for (const float rows : kRows) {
      choice.rows = rows;
      TreeLayout layout = Arrange(tree_, style_, choice);
      const float zoom = ZoomOf(layout.bounds);
      if (zoom < Readable(choice) || zoom <= largest) continue;
      largest = zoom;
      best_ = {choice, std::move(layout), Readable(choice), true};
    }
    return largest > 0;
  }

  // No longer than the canvas where they can be read.
  LayoutChoice RowsOf(Orientation orientation, bool compact) const {
    LayoutChoice choice;
    choice.orientation = orientation;
    choice.names_only = style_.ports != ShownPorts::kAll;
    choice.compact = compact;
    const bool down = orientation == Orientation::kTopToBottom;
    choice.limit = (down ? canvas_.x : canvas_.y) / Readable(choice);
    return choice;
  }

  // Top to bottom, unless it can only be read left to right, or is far larger there.
  bool TryTidy(bool names_only) {
    float zoom = 0;
    for (const Orientation orientation : {Orientation::kTopToBottom, Orientation::kLeftToRight}) {
      if (!IsAllowed(orientation)) continue;
      const LayoutChoice choice = {orientation, names_only};
      TreeLayout layout = Arrange(tree_, style_, choice);
      const float wanted = std::max(Readable(choice), zoom * kFarLarger);
      const float reached = std::min(ZoomOf(layout.bounds), kLargeEnough);
      if (reached < wanted) continue;
      zoom = reached;
      best_ = {choice, std::move(layout), Readable(choice), true};
    }
    return zoom > 0;
  }

  // As long as the canvas is broad, and of those what needs the least scrolling.
  ChosenLayout Page() {
    const bool across = style_.growth == Growth::kAcross;
    LayoutChoice choice =
        RowsOf(across ? Orientation::kLeftToRight : Orientation::kTopToBottom, false);
    const float readable = Readable(choice);
    if (!RowsAreAllowed()) return {choice, Arrange(tree_, style_, choice), readable, false};
    const float side = choice.limit;
    ChosenLayout best;
    float least_over = 0;
    for (const float part : {0.15F, 0.25F, 0.35F, 0.5F, 0.7F, 1.0F}) {
      choice.rows = side * part;
      TreeLayout layout = Arrange(tree_, style_, choice);
      const Point size = layout.bounds.max - layout.bounds.min;
      const float over = std::max(0.0F, (across ? size.y : size.x) - side);
      const bool is_better = best.layout.boxes.empty() || over < least_over ||
                             (over == least_over && Area(size) < Area(best));
      if (!is_better) continue;
      least_over = over;
      best = {choice, std::move(layout), readable, false};
    }
    return best;
  }

  static float Area(Point size) { return size.x * size.y; }
  static float Area(const ChosenLayout& chosen) {
    return Area(chosen.layout.bounds.max - chosen.layout.bounds.min);
  }

  bool IsAllowed(bool names_only) const {
    return style_.ports == ShownPorts::kByItself ||
           (style_.ports == ShownPorts::kNone) == names_only;
  }
  bool IsAllowed(Orientation orientation) const {
    return style_.growth == Growth::kByItself ||
           (style_.growth == Growth::kAcross) == (orientation == Orientation::kLeftToRight);
  }
  bool RowsAreAllowed() const { return style_.wrapped && !style_.layered; }
  static float Readable(const LayoutChoice& choice) {
    return choice.names_only ? kReadableNames : kReadablePorts;
  }

  float ZoomOf(const Box& bounds) const {
    return std::min(canvas_.x / std::max(bounds.width(), 1.0F),
                    canvas_.y / std::max(bounds.height(), 1.0F));
  }

  const MeasuredTree& tree_;
  const LayoutStyle& style_;
  const Point canvas_;
  ChosenLayout best_;
};

}  // namespace

ChosenLayout ChooseLayout(const MeasuredTree& tree, const LayoutStyle& style, Point canvas) {
  return Chooser(tree, style, canvas).Choose();
}

}  // namespace coppice::editor
