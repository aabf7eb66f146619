// Rouses a thread that waits for work. A wake-up that comes before the wait is not lost: it ends
// the next wait at once. Any thread may notify; one thread waits.
//
// One atomic word and, only while the waiter sleeps, one system call (futex(2)): notifying a thread
// that is awake costs a few nanoseconds. Rousing a sleeping thread takes the system 5 to 50 us; who
// is notified all the time can look out for it instead of sleeping (set_lookout).
#ifndef COPPICE_BT_CORE_BASE_WAKE_UP_H_
#define COPPICE_BT_CORE_BASE_WAKE_UP_H_

#include <atomic>
#include <chrono>
#include <cstdint>

namespace coppice {

class WakeUp {
 public:
  /// Any thread, and also a signal handler. What was written before is seen by the woken thread.
  void Notify() {
    if (state_.exchange(kNotified, std::memory_order_acq_rel) == kAsleep) Rouse();
  }

  /// Waits at most this long, in real time, for a notification and consumes it. True if there was
  /// one. nanoseconds::max() waits without limit.
  bool WaitFor(std::chrono::nanoseconds duration);

  /// The waiting thread: a wait that follows a wait shorter than this first looks out for the
  /// notification for so long, at the cost of the processor, before it sleeps. 0, the default:
  /// never.
  void set_lookout(std::chrono::nanoseconds lookout) { lookout_ = lookout; }

 private:
  enum State : std::uint32_t { kQuiet, kNotified, kAsleep };

  bool Consume();
  bool LookOut(std::chrono::nanoseconds duration) const;
  bool Sleep(std::chrono::nanoseconds duration);
  void Rouse();

  std::atomic<std::uint32_t> state_{kQuiet};
  // Of the waiting thread.
  std::chrono::nanoseconds lookout_{0};
  std::chrono::nanoseconds last_wait_{0};
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_WAKE_UP_H_
