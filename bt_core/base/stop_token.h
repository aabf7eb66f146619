// How work on another thread learns that nobody wants its result any more.
//
//   while (!stop.stop_requested() && Improve(plan)) {}
//   if (stop.WaitFor(std::chrono::seconds(1))) return Status::kFailure;   // instead of sleeping
//
// std::stop_token of C++20 in the size that is needed here.
#ifndef COPPICE_BT_CORE_BASE_STOP_TOKEN_H_
#define COPPICE_BT_CORE_BASE_STOP_TOKEN_H_

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "bt_core/base/clock.h"

namespace coppice {

class StopToken {
 public:
  /// Any thread. Costs one relaxed load: ask often.
  bool stop_requested() const { return requested_.load(std::memory_order_relaxed); }

  /// Any thread. Waits so long, in real time, but not longer than until the stop. True if the stop
  /// was requested.
  bool WaitFor(Duration duration) const;

  /// The owner's side.
  void RequestStop();
  void Reset() { requested_ = false; }

 private:
  std::atomic<bool> requested_{false};
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_STOP_TOKEN_H_
