// The loop that keeps a tree ticking: ticks when something arrived in the inbox, when a timer is
// due, and at a period for leaves that poll. In between it sleeps.
#ifndef COPPICE_BT_CORE_ENGINE_RUNNER_H_
#define COPPICE_BT_CORE_ENGINE_RUNNER_H_

#include <atomic>
#include <chrono>

#include "bt_core/engine/executor.h"

namespace coppice {

struct RunOptions {
  /// A tick at least this often. kNever: only on messages and timers.
  Duration period = std::chrono::milliseconds(100);
  /// Start again when the root has completed, as an arbiter does that runs for ever.
  bool forever = false;
};

/// Ticks until the root completes or `stop` becomes true; then halts the tree. To stop it from
/// another thread, set `stop` and notify executor.wake_up(). Returns the last result of the root.
Status Run(Executor& executor, const RunOptions& options, const std::atomic<bool>& stop);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_RUNNER_H_
