// The colour and the dot that stand for a run wherever runs are listed.
#ifndef COPPICE_EDITOR_PANELS_WIDGETS_RUN_DOT_H_
#define COPPICE_EDITOR_PANELS_WIDGETS_RUN_DOT_H_

#include "editor/live/run_need.h"
#include "editor/theme/ui.h"

namespace coppice::editor {

/// At a breakpoint, or paused.
bool IsStopped(const RunView& run);

/// Green: live; that of text: it stands; grey: it does not answer; violet: a simulation.
Color RunColor(const Ui& ui, const RunView& run);

/// Full, a ring as long as the run is not there, or two bars while it stands.
void DrawRunDot(const Ui& ui, ImDrawList& list, Point center, const RunView& run);

/// Of the sign that a robot needs somebody.
Color NeedColor(const Ui& ui, RunNeed::Level level);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_WIDGETS_RUN_DOT_H_
