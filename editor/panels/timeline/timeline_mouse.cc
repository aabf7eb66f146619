#include <algorithm>
#include <cmath>

#include "editor/commands/menus.h"
#include "editor/commands/run_commands.h"
#include "editor/panels/run/run_bodies.h"
#include "editor/panels/timeline/timeline_frame.h"

namespace coppice::editor {
namespace {

constexpr double kWheelPan = 0.08;
constexpr double kWheelZoom = 1.25;
constexpr float kDragDistance = 4;  // pixels; less is a click

class Mouse {
 public:
  explicit Mouse(TimelineFrame& frame) : f_(frame) {}

  void HandleMouse() {
    const Box all = {{f_.lanes.min.x, f_.overview.min.y}, f_.lanes.max};
    ImGui::SetCursorScreenPos(ToIm(all.min));
    ImGui::InvisibleButton("timeline", {all.width(), std::max(all.height(), 1.0F)},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                               ImGuiButtonFlags_MouseButtonRight);
    f_.ui.items.Add("timeline/overview", f_.overview);
    f_.ui.items.Add("timeline/ruler", f_.ruler);
    f_.ui.items.Add("timeline/lanes", f_.lanes);
    const ImGuiIO& io = ImGui::GetIO();
    const Point mouse = FromIm(io.MousePos);
    if (ImGui::IsItemHovered()) Wheel(io);
    if (ImGui::IsItemActivated()) {
      f_.shown.drag = !io.MouseDown[0]              ? TimelineDrag::kPan
                      : f_.overview.Contains(mouse) ? TimelineDrag::kOverview
                      : io.KeyShift                 ? TimelineDrag::kRange
                                                    : TimelineDrag::kScrub;
      f_.shown.drag_from = f_.TimeAtX(mouse.x);
      if (f_.shown.drag == TimelineDrag::kScrub && f_.lanes.Contains(mouse)) SelectLane(mouse.y);
    }
    if (ImGui::IsItemActive()) Drag(mouse, io);
    if (f_.labels.Contains(mouse) && io.MouseWheel != 0) {
      f_.shown.scroll -= io.MouseWheel * 3 * kLaneHeight * f_.ui.scale;
    }
    if (ImGui::IsItemHovered() && IsRightClick() && f_.lanes.Contains(mouse)) OpenMenuOf(mouse);
    if (f_.labels.Contains(mouse) && IsRightClick()) OpenMenuOf(mouse);
    if (ImGui::IsItemHovered() && io.MouseClicked[2] && f_.lanes.Contains(mouse)) FitBar(mouse);
  }

 private:
  void Wheel(const ImGuiIO& io) {
    if (io.MouseWheel == 0) return;
    if (io.KeyCtrl) {
      const double part = static_cast<double>((io.MousePos.x - f_.lanes.min.x) / f_.lanes.width());
      f_.shown.view.Zoom(std::pow(kWheelZoom, -io.MouseWheel), part);
    } else if (io.KeyShift) {
      f_.shown.scroll -= io.MouseWheel * 3 * kLaneHeight * f_.ui.scale;
    } else {
      f_.shown.view.Pan(-io.MouseWheel * kWheelPan);
    }
  }

  void Drag(Point mouse, const ImGuiIO& io) {
    switch (f_.shown.drag) {
      case TimelineDrag::kPan:
        if (io.MouseDelta.x != 0) {
          f_.shown.view.Pan(static_cast<double>(-io.MouseDelta.x / f_.lanes.width()));
        }
        break;
      case TimelineDrag::kScrub:
        GoTo(f_.TimeAtX(mouse.x));
        break;
      case TimelineDrag::kOverview: {
        const float part = (mouse.x - f_.overview.min.x) / f_.overview.width();
        GoTo(TimeFromNanoseconds(static_cast<std::int64_t>(
            std::clamp(part, 0.0F, 1.0F) * static_cast<double>(ToNanoseconds(f_.run_end)))));
        f_.shown.view.Reveal(f_.head.time());
        break;
      }
      case TimelineDrag::kRange: {
        const Time to = f_.TimeAtX(mouse.x);
        const auto range = std::minmax(f_.shown.drag_from, to);
        f_.shown.range.reset();
        if (range.first != range.second) f_.shown.range = range;
        break;
      }
    }
  }

  // Beyond the end lies now.
  void GoTo(Time time) {
    if (time > f_.run_end) return f_.head.GoToNow();
    f_.head.GoToTime(time);
    f_.shown.shown = f_.head.time();  // the user sees it already
    f_.shown.was_held = true;
    f_.shown.view.Pan(0);
  }

  NodeIndex NodeAt(float y) const {
    const std::size_t row = f_.RowAt(y);
    return row < f_.shown.listed.size() ? f_.shown.listed[row] : kNoNode;
  }

  static bool IsRightClick() {
    const ImVec2 way = ImGui::GetMouseDragDelta(1, kDragDistance);
    return ImGui::IsMouseReleased(1) && way.x == 0 && way.y == 0;
  }

  void OpenMenuOf(Point mouse) {
    SelectLane(mouse.y);
    OpenMenu(f_.state, menu::kLane, mouse);
  }

  void SelectLane(float y) { SelectRunNode(f_.state, NodeAt(y)); }

  // A click of the middle button on a bar shows it whole.
  void FitBar(Point mouse) {
    const NodeIndex node = NodeAt(mouse.y);
    if (node == kNoNode) return;
    const Lane& lane = f_.tracks.LaneOf(node);
    const std::size_t tick = f_.run.TickAt(f_.TimeAtX(mouse.x));
    const std::size_t first = lane.Since(tick);
    const std::size_t end = lane.NextChange(tick);
    f_.shown.view.Fit(f_.run.TimeOf(first), end > tick ? f_.run.TimeOf(end) : f_.run_end);
  }

  TimelineFrame& f_;
};

}  // namespace

void HandleTimelineMouse(TimelineFrame& frame) { Mouse(frame).HandleMouse(); }

}  // namespace coppice::editor
