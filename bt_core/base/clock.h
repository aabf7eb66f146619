// The time that a tree lives in. A tree never reads the computer's clock: it is handed a Clock, so
// the same tree runs on wall time, on ROS time and on simulated time.
#ifndef COPPICE_BT_CORE_BASE_CLOCK_H_
#define COPPICE_BT_CORE_BASE_CLOCK_H_

#include <atomic>
#include <chrono>
#include <cstdint>

#include "bt_core/base/wake_up.h"

namespace coppice {

class Clock;

/// A length of time. Signed 64-bit nanoseconds.
using Duration = std::chrono::nanoseconds;

/// A moment of a Clock: the Duration since its origin, which is Time{}. The difference of two is a
/// Duration; two cannot be added, and no other clock's moments are taken for it.
using Time = std::chrono::time_point<Clock, Duration>;

/// A moment since 1970, as people have it.
using WallTime = std::chrono::time_point<std::chrono::system_clock, Duration>;

inline constexpr Time kNever = Time::max();
inline constexpr Duration kForever = Duration::max();

/// As a number, for files and messages.
constexpr std::int64_t ToNanoseconds(Time time) { return time.time_since_epoch().count(); }
constexpr Time TimeFromNanoseconds(std::int64_t count) { return Time(Duration(count)); }

class Clock {
 public:
  virtual ~Clock() = default;

  /// The time now. Never goes back. Called by the ticking thread, and by any other.
  virtual Time Now() const = 0;

  /// Waits until `deadline` of this clock has come or `wake_up` was notified, whichever is first.
  /// May return early; the caller looks at Now(). Called by the ticking thread.
  virtual void WaitUntil(Time deadline, WakeUp& wake_up) = 0;
};

/// Nanoseconds since 1970 when the clock was made, going on monotonically from there (a change of
/// the system's clock does not disturb a running tree).
class WallClock : public Clock {
 public:
  WallClock();
  Time Now() const override;
  void WaitUntil(Time deadline, WakeUp& wake_up) override;

 private:
  Duration offset_;  // of the system clock from the steady clock
};

/// Time that stands still until someone moves it. Waiting jumps to the deadline, so a tree runs as
/// fast as the computer can, with exact times. With a deadline of kNever it waits for the wake-up
/// in real time.
class SimulatedClock : public Clock {
 public:
  /// Begins so long after its origin.
  explicit SimulatedClock(Duration start = Duration::zero()) : now_(start.count()) {}
  Time Now() const override { return TimeFromNanoseconds(now_.load()); }
  void WaitUntil(Time deadline, WakeUp& wake_up) override;

  void Advance(Duration duration) { now_ += duration.count(); }

 private:
  std::atomic<std::int64_t> now_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_CLOCK_H_
