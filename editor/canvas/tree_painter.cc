#include "editor/canvas/tree_painter.h"

#include <algorithm>
#include <unordered_set>
#include <vector>

#include "editor/canvas/canvas_looks.h"
#include "editor/canvas/paint/node_marks.h"
#include "editor/canvas/paint/node_painter.h"
#include "editor/canvas/tree_lines.h"

namespace coppice::editor {
namespace {

constexpr float kGroundSide = 8;  // of the ground beside the nodes of a SubTree, at zoom 1

class TreePainter {
 public:
  TreePainter(Pen& pen, const PaintArea& area)
      : pen_(pen),
        colors_(pen.ui.palette),
        area_(area),
        view_(area.view),
        scene_(*area.view.scene()),
        detail_(DetailFor(area.camera.zoom, pen.ui.scale)) {}

  void Paint() {
    if (detail_ != Detail::kBlock) PaintGround();
    PaintLines(pen_, area_);
    for (const VisibleNode& item : area_.visible) PaintItem(item);
  }

 private:
  const SceneNode& NodeOf(const VisibleNode& item) const {
    return scene_.nodes[view_.shown()[item.k]];
  }

  // A part of the ground of a SubTree.
  struct Ground {
    std::uint32_t scope;
    Box box;
  };

  // What belongs to a SubTree lies on a ground with an outline of its own, to which its node is the
  // tab. SubTrees side by side differ in shade.
  void PaintGround() {
    std::vector<Ground> grounds = view_.in_rows() ? Blocks() : Bands();
    std::stable_sort(grounds.begin(), grounds.end(),
                     [](const Ground& a, const Ground& b) { return a.scope < b.scope; });
    const float line = pen_.ui.scale;
    for (auto first = grounds.begin(); first != grounds.end();) {
      const std::uint32_t scope = first->scope;
      const auto end = std::find_if(first, grounds.end(),
                                    [scope](const Ground& one) { return one.scope != scope; });
      // The outline of all parts together is what their fillings leave of it.
      const Color edge = Mix(colors_.canvas, colors_.text, 0.22F);
      const Color fill = Mix(colors_.canvas, colors_.text, scope % 2 == 1 ? 0.05F : 0.085F);
      for (auto one = first; one != end; ++one) PaintGround(Grown(one->box, line), edge);
      for (auto one = first; one != end; ++one) PaintGround(one->box, fill);
      first = end;
    }
  }

  void PaintGround(const Box& box, Color color) {
    if (box.Overlaps(area_.box)) pen_.FillBox(box, color, 6 * area_.camera.zoom);
  }

  // In rows, no other branch reaches between the nodes of a SubTree: it is a block.
  std::vector<Ground> Blocks() const {
    std::vector<Ground> blocks;
    std::unordered_set<std::uint32_t> found;  // scopes
    for (const VisibleNode& item : area_.visible) {
      for (std::uint32_t k = item.k; k != 0; k = view_.ShownParent(k)) {
        const std::uint32_t scope = ScopeOf(k);
        if (scope == 0) break;
        if (scope == ScopeOf(view_.ShownParent(k))) continue;
        if (!found.insert(scope).second) break;
        blocks.push_back({scope, area_.camera.ToScreen(BlockBelow(view_.ShownParent(k), k))});
      }
    }
    return blocks;
  }

  std::uint32_t ScopeOf(std::uint32_t k) const { return scene_.nodes[view_.shown()[k]].scope; }

  Box BlockBelow(std::uint32_t parent, std::uint32_t root) const {
    const Box above = view_.BoxAt(parent, pen_.ui.now);
    Box block = Grown(view_.BranchBounds(root), kGroundSide);
    const bool down = view_.orientation() == Orientation::kTopToBottom;
    (down ? block.min.y : block.min.x) = down ? above.max.y : above.max.x;
    (down ? block.min.x : block.min.y) = down ? above.min.x : above.min.y;
    return block;
  }

  // In a tidy tree, a band behind all children of a node, which reaches to the bands above and
  // below.
  std::vector<Ground> Bands() const {
    std::vector<Ground> bands;
    std::unordered_set<std::uint32_t> found;  // parents
    for (const VisibleNode& item : area_.visible) {
      const std::uint32_t scope = NodeOf(item).scope;
      if (scope == 0 || item.k == 0 || !found.insert(view_.ShownParent(item.k)).second) continue;
      bands.push_back({scope, BandBelow(view_.ShownParent(item.k))});
    }
    return bands;
  }

  // Around the children, from where their parent ends.
  Box BandBelow(std::uint32_t parent) const {
    const bool down = view_.orientation() == Orientation::kTopToBottom;
    Box band = view_.BoxAt(parent + 1, pen_.ui.now);
    for (std::uint32_t c = parent + 1; c < view_.shown_ends()[parent]; c = view_.shown_ends()[c]) {
      band = Union(band, view_.BoxAt(c, pen_.ui.now));
    }
    const Box above = view_.BoxAt(parent, pen_.ui.now);
    if (down) {
      band = {{band.min.x - kGroundSide, std::min(band.min.y, above.max.y)},
              {band.max.x + kGroundSide, band.max.y + kGroundSide}};
    } else {
      band = {{std::min(band.min.x, above.max.x), band.min.y - kGroundSide},
              {band.max.x + kGroundSide, band.max.y + kGroundSide}};
    }
    return area_.camera.ToScreen(band);
  }

  void PaintItem(const VisibleNode& item) {
    if (!item.box.Overlaps(area_.box)) return;
    if (item.whole_branch) return PaintBranch(item);
    NodeLook look = LookOf(view_, area_.options, item.k, item.box, area_.camera.zoom);
    look.hovered = area_.hovered == &item;
    PaintNode(pen_, scene_, NodeOf(item), look);
    PaintMarks(pen_, look);
  }

  // A branch of a few pixels still shows what runs and what is wrong in it.
  void PaintBranch(const VisibleNode& item) {
    Color color = colors_.Of(NodeOf(item).shape);
    const std::uint32_t first = view_.shown()[item.k];
    for (std::uint32_t i = first; i < scene_.nodes[first].end; ++i) {
      if (BadgeOf(area_.options, i) == Badge::kError) color = colors_.error;
      const Status status = StateOf(area_.options.live, scene_.nodes[i]).status;
      if (status == Status::kRunning) color = colors_.running;
    }
    pen_.FillBox(item.box, color);
  }

  static Box Grown(const Box& box, float by) {
    return {box.min - Point{by, by}, box.max + Point{by, by}};
  }

  Pen& pen_;
  const Palette& colors_;
  const PaintArea& area_;
  const TreeView& view_;
  const Scene& scene_;
  const Detail detail_;
};

}  // namespace

void PaintTree(Pen& pen, const PaintArea& area) { TreePainter(pen, area).Paint(); }

}  // namespace coppice::editor
