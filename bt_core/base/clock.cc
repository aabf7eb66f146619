#include "bt_core/base/clock.h"

namespace coppice {
namespace {

Time SteadyNow() { return std::chrono::steady_clock::now().time_since_epoch(); }

}  // namespace

WallClock::WallClock()
    : offset_(std::chrono::system_clock::now().time_since_epoch() - SteadyNow()) {}

Time WallClock::Now() const { return SteadyNow() + offset_; }

void WallClock::WaitUntil(Time deadline, WakeUp& wake_up) {
  const Time now = Now();
  if (deadline <= now) return;
  wake_up.WaitFor(deadline == kNever ? Duration::max() : deadline - now);
}

void SimulatedClock::WaitUntil(Time deadline, WakeUp& wake_up) {
  if (wake_up.WaitFor(deadline == kNever ? Duration::max() : Duration::zero())) return;
  if (deadline != kNever && deadline > Now()) now_ = deadline.count();
}

}  // namespace coppice
