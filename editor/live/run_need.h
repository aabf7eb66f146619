// Whether a robot needs somebody, and why: for who looks after many.
#ifndef COPPICE_EDITOR_LIVE_RUN_NEED_H_
#define COPPICE_EDITOR_LIVE_RUN_NEED_H_

#include <string>

#include "editor/live/run_view.h"

namespace coppice::editor {

struct RunNeed {
  /// kLook: somebody should have a look; kCome: somebody has to come.
  enum class Level { kNone, kLook, kCome } level = Level::kNone;
  std::string why;  ///< "does not answer"; empty with kNone
};

/// As the robot stands now, whichever tick is shown. It has to come who is asked (a leaf that asks
/// people runs, or has failed in the newest tick, AsksPeople()) and if the robot does not answer
/// any more; it should look who stopped it, and if its tree has ended with FAILURE or was never
/// reached.
RunNeed NeedOf(const RunView& run);

/// Where a robot stands: "PAUSED before "patrol/Drive""; empty if it runs.
std::string StopText(const RunView& run);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_RUN_NEED_H_
