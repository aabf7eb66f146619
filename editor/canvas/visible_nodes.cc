#include "editor/canvas/visible_nodes.h"

namespace coppice::editor {
namespace {

constexpr float kSmallBranch = 3;   // pixels
constexpr float kFarZoom = 0.045F;  // nodes are too small to be told apart:
constexpr float kFarBranch = 64;    // larger branches are one block
constexpr float kMargin = 18;       // what is painted around a node at zoom 1

Box Grown(const Box& box, float pixels) {
  return {box.min - Point{pixels, pixels}, box.max + Point{pixels, pixels}};
}

}  // namespace

std::vector<VisibleNode> FindVisible(const TreeView& view, const Camera& camera, const Box& canvas,
                                     double now) {
  std::vector<VisibleNode> visible;
  const bool moving = view.IsMoving(now);
  const float margin = kMargin * std::max(camera.zoom, 0.5F);
  const auto box_of = [&](std::uint32_t k) { return camera.ToScreen(view.BoxAt(k, now)); };
  const auto count = static_cast<std::uint32_t>(view.shown().size());
  for (std::uint32_t k = 0; k < count;) {
    const Box branch = camera.ToScreen(view.BranchBounds(k));
    if (!moving && !Grown(branch, margin).Overlaps(canvas)) {
      // The line from the parent to a branch that is out of sight may cross the canvas.
      if (k > 0) {
        const EdgeEnds ends = camera.ToScreen(view.EdgeTo(k, now));
        const EdgeBounds line = BoundsOf(ends);
        if (line.stem.Overlaps(canvas) || line.rest.Overlaps(canvas)) {
          visible.push_back({k, ends.child, false});
        }
      }
      k = view.shown_ends()[k];
      continue;
    }
    const float small = camera.zoom < kFarZoom ? kFarBranch : kSmallBranch;
    const bool tiny = branch.width() < small && branch.height() < small;
    visible.push_back({k, tiny ? branch : box_of(k), tiny});
    k = tiny ? view.shown_ends()[k] : k + 1;
  }
  return visible;
}

}  // namespace coppice::editor
