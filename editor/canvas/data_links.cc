#include "editor/canvas/data_links.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/paint/node_painter.h"

namespace coppice::editor {
namespace {

constexpr std::size_t kMostLinks = 400;

class LinkPainter {
 public:
  LinkPainter(Pen& pen, const TreeView& view, const Camera& camera)
      : pen_(pen), view_(view), camera_(camera), scene_(*view.scene()) {}

  void Paint() {
    const std::vector<KeyUse>& uses = view_.keys().uses[view_.lit_key()];
    color_ = pen_.ui.palette.OfKey(view_.keys().names[view_.lit_key()]);
    std::size_t count = 0;
    for (const KeyUse& writer : uses) {
      for (const KeyUse& reader : uses) {
        if (!writer.writes || !reader.reads || writer.node == reader.node) continue;
        if (++count > kMostLinks) return;
        PaintLink(writer, reader);
      }
    }
  }

 private:
  Box RowOf(const KeyUse& use) const {
    const std::uint32_t k = view_.ShownOf(use.node);
    NodeLook look;
    look.box = camera_.ToScreen(view_.BoxAt(k, pen_.ui.now));
    look.zoom = camera_.zoom;
    look.whole_values = view_.style().whole_values;
    const SceneNode& node = scene_.nodes[use.node];
    const bool hidden = view_.shown()[k] != use.node;
    if (hidden || view_.names_only() || DetailFor(camera_.zoom, pen_.ui.scale) != Detail::kFull) {
      return look.box;
    }
    return PortBox(scene_, node, look, use.port - node.first_port);
  }

  // From the side of the writer that looks at the reader, with an arrow at the end.
  void PaintLink(const KeyUse& writer, const KeyUse& reader) {
    const Box from = RowOf(writer);
    const Box to = RowOf(reader);
    const bool right = to.center().x >= from.center().x;
    const Point a = {right ? from.max.x : from.min.x, from.center().y};
    const bool from_left = to.center().x >= from.max.x;
    const Point d = {from_left ? to.min.x : to.max.x, to.center().y};
    const float bend = std::max(40 * camera_.zoom, std::abs(d.x - a.x) * 0.45F);
    const float side = from_left ? -1.0F : 1.0F;
    const float thick = std::max(1.5F, 2 * camera_.zoom);
    pen_.Curve(a, {a.x + (right ? bend : -bend), a.y}, {d.x + side * bend, d.y}, d, color_, thick);
    pen_.Disc(a, thick * 1.6F, color_);
    const float size = std::max(5.0F, 7 * camera_.zoom);
    pen_.Fill(
        {{d.x, d.y}, {d.x + side * size, d.y - size / 2}, {d.x + side * size, d.y + size / 2}},
        color_);
  }

  Pen& pen_;
  const TreeView& view_;
  const Camera& camera_;
  const Scene& scene_;
  Color color_ = 0;
};

}  // namespace

void PaintDataLinks(Pen& pen, const TreeView& view, const Camera& camera) {
  if (view.lit_key() != kNoKey) LinkPainter(pen, view, camera).Paint();
}

bool IsLit(const TreeView& view, std::uint32_t node) {
  if (view.lit_key() == kNoKey) return true;
  const std::vector<KeyUse>& uses = view.keys().uses[view.lit_key()];
  const std::uint32_t end = view.IsCollapsed(node) ? view.scene()->nodes[node].end : node + 1;
  const auto first =
      std::lower_bound(uses.begin(), uses.end(), node,
                       [](const KeyUse& use, std::uint32_t n) { return use.node < n; });
  return first != uses.end() && first->node < end;
}

}  // namespace coppice::editor
