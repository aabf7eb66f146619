// What of a gesture is to be seen, and its end.
#include <algorithm>

#include "editor/canvas/canvas_mouse.h"

namespace coppice::editor {
namespace {

constexpr float kScrollBorder = 28;  // pixels at the edge of the canvas
constexpr float kScrollSpeed = 700;  // pixels per second

class GestureView {
 public:
  GestureView(Pen& pen, TreeView& view, const Box& box, const CanvasOptions& options)
      : pen_(pen), view_(view), box_(box), options_(options), io_(ImGui::GetIO()) {
    camera_ = view.camera;
    camera_.offset = camera_.offset + box.min;
    mouse_ = FromIm(io_.MousePos);
  }

  void Draw() {
    const DropHandler* handler = options_.drop;
    if (view_.gesture.kind == Gesture::Kind::kRectangle) return Rectangle();
    if (!handler || !handler->why_not) return;
    if (view_.gesture.kind == Gesture::Kind::kDrag) {
      const Drag drag = view_.gesture.drag;
      Carry(drag, *handler);
      // What was carried is still known when the drop is done, after the frame.
      if (!ImGui::IsMouseDown(0)) view_.gesture.kind = Gesture::Kind::kNone;
    } else if (handler->incoming && box_.Contains(mouse_)) {
      Carry(*handler->incoming, *handler);
    }
  }

 private:
  void Rectangle() {
    const Point start = camera_.ToScreen(view_.gesture.start);
    const Box area = Union({start, start}, {mouse_, mouse_});
    pen_.FillBox(area, Fade(pen_.ui.palette.accent, 0.12F));
    pen_.FrameBox(area, pen_.ui.palette.accent);
    std::vector<std::uint32_t> nodes =
        io_.KeyCtrl ? view_.selection() : std::vector<std::uint32_t>();
    const Box world = {camera_.ToWorld(area.min), camera_.ToWorld(area.max)};
    for (std::uint32_t k = 0; k < view_.shown().size();) {
      if (!view_.BranchBounds(k).Overlaps(world)) {
        k = view_.shown_ends()[k];
        continue;
      }
      if (view_.BoxAt(k, pen_.ui.now).Overlaps(world)) nodes.push_back(view_.shown()[k]);
      ++k;
    }
    view_.SelectAll(std::move(nodes));
  }

  void Carry(const Drag& drag, const DropHandler& handler) {
    if (!pen_.ui.reduce_motion || box_.Contains(mouse_)) Scroll();
    DropRequest request;
    if (box_.Contains(mouse_)) {
      request.target = FindDropTarget(view_, camera_.ToWorld(mouse_), pen_.ui.now);
    }
    request.copy = io_.KeyShift;
    request.replace = io_.KeyAlt;
    std::string reason;
    if (request.target.place != DropPlace::kNowhere) {
      reason = handler.why_not(drag, request);
      Mark(request, reason.empty());
    }
    Ghost(drag, request, reason);
    const bool here = request.target.place != DropPlace::kNowhere && reason.empty();
    if (ImGui::IsMouseReleased(0) && here && handler.drop) handler.drop(drag, request);
  }

  // At the edge of the canvas the tree comes to meet the mouse.
  void Scroll() {
    const float step = kScrollSpeed * io_.DeltaTime;
    const auto pull = [step](float low, float high, float at) {
      if (at < low + kScrollBorder) return step;
      return at > high - kScrollBorder ? -step : 0.0F;
    };
    view_.camera.offset = view_.camera.offset + Point{pull(box_.min.x, box_.max.x, mouse_.x),
                                                      pull(box_.min.y, box_.max.y, mouse_.y)};
  }

  void Mark(const DropRequest& request, bool allowed) {
    const Palette& colors = pen_.ui.palette;
    const Color color = allowed ? colors.accent : colors.error;
    const Box mark = camera_.ToScreen(request.target.mark);
    pen_.ui.items.Add("canvas/drop", mark);
    const float scale = pen_.ui.scale;
    switch (request.target.place) {
      case DropPlace::kNode:
        pen_.FillBox(mark, Fade(color, 0.07F), 4 * scale);
        pen_.FrameBox(mark, color, 4 * scale, 2.5F * scale);
        break;
      case DropPlace::kEdge:
        pen_.Disc(mark.center(), 7 * scale, color);
        pen_.Disc(mark.center(), 3 * scale, colors.canvas);
        break;
      case DropPlace::kGap:
        pen_.FillBox(mark, color, 2);
        pen_.Disc(mark.width() > mark.height() ? Point{mark.min.x, mark.center().y}
                                               : Point{mark.center().x, mark.min.y},
                  5 * scale, color);
        break;
      case DropPlace::kNowhere:
        break;
    }
  }

  void Ghost(const Drag& drag, const DropRequest& request, const std::string& reason) {
    const Palette& colors = pen_.ui.palette;
    const float scale = pen_.ui.scale;
    const TextStyle name{Face::kBold, 12, colors.text};
    const TextStyle small{Face::kSans, 11, reason.empty() ? colors.text_dim : colors.error};
    const std::string below = reason.empty() ? Meaning(request) : reason;
    const float width = std::max(pen_.Width(drag.label, name), pen_.Width(below, small));
    const Point at = mouse_ + Point{16, 10} * scale;
    const float high = (below.empty() ? 24 : 42) * scale;
    const Box box = {at, at + Point{width + 20 * scale, high}};
    pen_.FillBox(box, colors.panel, 5 * scale);
    pen_.FrameBox(box, reason.empty() ? colors.accent : colors.error, 5 * scale, 1.5F);
    pen_.RowText(at + Point{10 * scale, 2 * scale}, 20 * scale, drag.label, name);
    pen_.RowText(at + Point{10 * scale, 21 * scale}, 18 * scale, below, small);
    pen_.ui.items.Add("canvas/ghost", box);
  }

  std::string Meaning(const DropRequest& request) const {
    const std::string verb = request.copy ? "copy " : "";
    const DropTarget& target = request.target;
    if (target.place == DropPlace::kNowhere) return {};
    const std::string name(view_.scene()->nodes[target.node].name);
    switch (target.place) {
      case DropPlace::kGap:
        return verb + "into " + name + ", place " + std::to_string(target.index + 1);
      case DropPlace::kEdge:
        return verb + "above " + name;
      default:
        return verb + (request.replace ? "in place of " : "into ") + name;
    }
  }

  Pen& pen_;
  TreeView& view_;
  const Box box_;
  const CanvasOptions& options_;
  const ImGuiIO& io_;
  Camera camera_;
  Point mouse_;
};

}  // namespace

void DrawGesture(Pen& pen, TreeView& view, const Box& box, const CanvasOptions& options) {
  GestureView(pen, view, box, options).Draw();
}

}  // namespace coppice::editor
