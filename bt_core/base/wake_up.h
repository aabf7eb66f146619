// Rouses a thread that waits for work. A wake-up that comes before the wait is not lost: it ends
// the next wait at once. Any thread may notify; one thread waits.
#ifndef COPPICE_BT_CORE_BASE_WAKE_UP_H_
#define COPPICE_BT_CORE_BASE_WAKE_UP_H_

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace coppice {

class WakeUp {
 public:
  void Notify() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      notified_ = true;
    }
    condition_.notify_one();
  }

  /// Waits at most this long for a notification and consumes it. True if there was one.
  bool WaitFor(std::chrono::nanoseconds duration) {
    std::unique_lock<std::mutex> lock(mutex_);
    const bool woken = condition_.wait_for(lock, duration, [this] { return notified_; });
    notified_ = false;
    return woken;
  }

 private:
  std::mutex mutex_;
  std::condition_variable condition_;
  bool notified_ = false;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_WAKE_UP_H_
