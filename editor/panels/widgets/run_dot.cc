#include "editor/panels/widgets/run_dot.h"

namespace coppice::editor {

bool IsStopped(const RunView& run) { return run.stop().where != DebugStop::Where::kNowhere; }

Color RunColor(const Ui& ui, const RunView& run) {
  if (IsStopped(run)) return ui.palette.text;
  switch (run.phase()) {
    case RunPhase::kLive:
      return ui.palette.success;
    case RunPhase::kConnecting:
    case RunPhase::kLeft:
    case RunPhase::kLoading:
    case RunPhase::kRecord:
      return ui.palette.accent;
    case RunPhase::kSimulation:
      return ui.palette.simulation;
    case RunPhase::kReconnecting:
      return ui.palette.text_dim;
  }
  return ui.palette.text_dim;
}

void DrawRunDot(const Ui& ui, ImDrawList& list, Point center, const RunView& run) {
  if (IsStopped(run)) {
    const Point half = Point{1.4F, 4.5F} * ui.scale;
    for (const float side : {-2.6F, 2.6F}) {
      const Point middle = center + Point{side * ui.scale, 0};
      ui.Fill(list, {middle - half, middle + half}, RunColor(ui, run));
    }
    return;
  }
  const bool is_there =
      run.phase() != RunPhase::kReconnecting && run.phase() != RunPhase::kConnecting;
  const float radius = 4.5F * ui.scale;
  if (is_there) {
    list.AddCircleFilled(ToIm(center), radius, RunColor(ui, run));
  } else {
    list.AddCircle(ToIm(center), radius, RunColor(ui, run), 0, 1.5F * ui.scale);
  }
}

Color NeedColor(const Ui& ui, RunNeed::Level level) {
  return level == RunNeed::Level::kCome ? ui.palette.error : ui.palette.warning;
}

}  // namespace coppice::editor
