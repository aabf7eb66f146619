// Rouses a thread that waits for work. A wake-up that comes before the wait is not lost: it ends
// the next wait at once. Any thread may notify; one thread waits.
//
// One atomic word and, only while the waiter sleeps, one system call (futex(2)): notifying a thread
// that is awake costs a few nanoseconds.
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

 private:
  enum State : std::uint32_t { kQuiet, kNotified, kAsleep };

  bool Consume();
  void Rouse();

  std::atomic<std::uint32_t> state_{kQuiet};
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_WAKE_UP_H_
