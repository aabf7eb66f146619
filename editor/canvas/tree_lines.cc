#include "editor/canvas/tree_lines.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "editor/canvas/canvas_looks.h"
#include "editor/canvas/paint/edge_painter.h"
#include "editor/canvas/paint/node_painter.h"
#include "editor/canvas/paint/status_look.h"

namespace coppice::editor {
namespace {

bool IsAtRest(const EdgeLook& look) {
  return look.state.status == Status::kIdle && !IsTrail(look.state) && look.change == Change::kNone;
}

class LinesPainter {
 public:
  LinesPainter(Pen& pen, const PaintArea& area)
      : pen_(pen),
        area_(area),
        view_(area.view),
        scene_(*area.view.scene()),
        far_(DetailFor(area.camera.zoom, pen.ui.scale) == Detail::kBlock) {}

  // From the last to the first, because the stem of a sibling covers those of all before it.
  void Paint() {
    for (auto item = area_.visible.rbegin(); item != area_.visible.rend(); ++item) {
      if (item->k > 0 && !item->whole_branch) PaintOrKeep(*item);
    }
    std::stable_partition(busy_.begin(), busy_.end(), [](const EdgeLook& look) {
      return look.state.status != Status::kRunning;
    });
    for (const EdgeLook& look : busy_) PaintOne(look);
  }

 private:
  const SceneNode& NodeOf(std::uint32_t k) const { return scene_.nodes[view_.shown()[k]]; }

  void PaintOrKeep(const VisibleNode& item) {
    EdgeLook look;
    look.ends = EndsOf(item.k);
    const EdgeBounds bounds = BoundsOf(look.ends);
    const bool with_rest = bounds.rest.Overlaps(area_.box);
    if (!with_rest && !bounds.stem.Overlaps(area_.box)) return;
    look.state = StateOf(area_.options.live, NodeOf(item.k));
    look.change = ChangeOf(area_.options, view_.shown()[item.k]);
    const bool at_rest = IsAtRest(look);
    if (at_rest && HasStem(look.ends)) {
      look.stem = has_stem_.insert({view_.ShownParent(item.k), bounds.lane}).second;
      if (!look.stem && !with_rest) return;
    }
    look.offline = area_.options.live && !area_.options.live->is_fresh;
    look.number = NumberOf(NodeOf(item.k));
    if (view_.lit_key() != kNoKey) look.strength = kDimmed;
    if (at_rest) {
      PaintOne(look);
    } else {
      busy_.push_back(look);
    }
  }

  EdgeEnds EndsOf(std::uint32_t k) const {
    EdgeEnds ends = view_.EdgeTo(k, pen_.ui.now);
    ends.parent_note = NoteHeight(NodeOf(view_.ShownParent(k)), view_.names_only());
    ends.child_note = NoteHeight(NodeOf(k), view_.names_only());
    return area_.camera.ToScreen(ends);
  }

  // An only child has none.
  std::uint32_t NumberOf(const SceneNode& node) const {
    const bool alone = node.number == 1 && node.end == scene_.nodes[node.parent].end;
    return alone ? 0 : node.number;
  }

  void PaintOne(const EdgeLook& look) { far_ ? PaintFarEdge(pen_, look) : PaintEdge(pen_, look); }

  Pen& pen_;
  const PaintArea& area_;
  const TreeView& view_;
  const Scene& scene_;
  const bool far_;
  std::set<std::pair<std::uint32_t, float>> has_stem_;  // shown parents, and lanes
  std::vector<EdgeLook> busy_;
};

}  // namespace

void PaintLines(Pen& pen, const PaintArea& area) { LinesPainter(pen, area).Paint(); }

}  // namespace coppice::editor
