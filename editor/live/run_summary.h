// What the strip of runs says of one behind its name.
#ifndef COPPICE_EDITOR_LIVE_RUN_SUMMARY_H_
#define COPPICE_EDITOR_LIVE_RUN_SUMMARY_H_

#include <string>

#include "editor/live/run_view.h"

namespace coppice::editor {

/// "10 Hz   tick 84", "record   tick 84", "loading 40 %", "connecting: no answer". The tick is the
/// newest one, by the robot's own number as in the timeline.
std::string SummaryOf(const RunView& run);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_RUN_SUMMARY_H_
