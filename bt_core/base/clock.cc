#include "bt_core/base/clock.h"

namespace coppice {
namespace {

Duration SteadyNow() { return std::chrono::steady_clock::now().time_since_epoch(); }

}  // namespace

WallClock::WallClock()
    : offset_(std::chrono::system_clock::now().time_since_epoch() - SteadyNow()) {}

Time WallClock::Now() const { return Time(SteadyNow() + offset_); }

void WallClock::WaitUntil(Time deadline, WakeUp& wake_up) {
  const Time now = Now();
  if (deadline <= now) return;
  wake_up.WaitFor(deadline == kNever ? kForever : deadline - now);
}

void SimulatedClock::WaitUntil(Time deadline, WakeUp& wake_up) {
  if (wake_up.WaitFor(deadline == kNever ? kForever : Duration::zero())) return;
  if (deadline != kNever && deadline > Now()) now_ = ToNanoseconds(deadline);
}

}  // namespace coppice
