#include "bt_core/engine/runner.h"

#include <algorithm>

namespace coppice {

Status Run(Executor& executor, const RunOptions& options, const std::atomic<bool>& stop) {
  Status result = Status::kIdle;
  while (!stop) {
    result = executor.Tick();
    if (result != Status::kRunning && !options.forever) break;
    const Time latest = options.period == kNever ? kNever : executor.now() + options.period;
    const Time next = std::min(executor.next_tick(), latest);
    // Calls of remote clients are served without a tick; a message or the time ends the wait.
    while (!stop && !executor.inbox()->has_messages() && executor.clock().Now() < next) {
      executor.clock().WaitUntil(next, executor.wake_up());
      executor.RunCalls();
    }
  }
  executor.Halt();
  return result;
}

}  // namespace coppice
