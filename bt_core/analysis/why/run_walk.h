// Goes through a run in order, with the statuses that follow from its events: what all exports
// have in common.
#ifndef COPPICE_BT_CORE_ANALYSIS_WHY_RUN_WALK_H_
#define COPPICE_BT_CORE_ANALYSIS_WHY_RUN_WALK_H_

#include <optional>

#include "bt_core/analysis/recording.h"
#include "bt_core/frames/follower.h"

namespace coppice {

/// Calls of WalkRun, in the order of happening.
class RunVisitor {
 public:
  virtual ~RunVisitor() = default;
  /// Another tree, and the state at a place where it is known anew.
  virtual void OnSection(const TreeDescription&, const Recording::Section&) {}
  virtual void OnTickBegin(const TickEvents&) {}
  virtual void OnEvent(const Event&, const TickEvents&) {}
  /// After OnEvent of the event that it follows from.
  virtual void OnChange(const StatusChange&, const TickEvents&) {}
  virtual void OnTickEnd(const TickEvents&) {}
};

/// Keyframes are left out: nothing happens there.
void WalkRun(const Recording& run, RunVisitor& visitor);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_WHY_RUN_WALK_H_
