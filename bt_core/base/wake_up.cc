#include "bt_core/base/wake_up.h"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace coppice {
namespace {

using std::chrono::nanoseconds;

timespec Deadline(nanoseconds after) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  const std::int64_t fraction = now.tv_nsec + after.count() % kSecond;
  return {static_cast<time_t>(now.tv_sec + after.count() / kSecond + fraction / kSecond),
          static_cast<long>(fraction % kSecond)};
}

}  // namespace

bool WakeUp::Consume() { return state_.exchange(kQuiet, std::memory_order_acq_rel) == kNotified; }

void WakeUp::Rouse() {
  const int error = errno;  // a signal handler must leave it as it was
  syscall(SYS_futex, &state_, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0);
  errno = error;
}

bool WakeUp::WaitFor(nanoseconds duration) {
  if (duration <= nanoseconds::zero() || lookout_ <= nanoseconds::zero()) return Sleep(duration);
  const auto start = std::chrono::steady_clock::now();
  const bool expects_it_soon = last_wait_ < lookout_;
  const bool came =
      (expects_it_soon && LookOut(std::min(duration, lookout_)) && Consume()) || Sleep(duration);
  last_wait_ = std::chrono::steady_clock::now() - start;
  return came;
}

// True if the notification came in time.
bool WakeUp::LookOut(nanoseconds duration) const {
  constexpr int kLooks = 64;  // between two looks at the clock
  const auto end = std::chrono::steady_clock::now() + duration;
  do {
    for (int i = 0; i < kLooks; ++i) {
      if (state_.load(std::memory_order_acquire) == kNotified) return true;
    }
  } while (std::chrono::steady_clock::now() < end);
  return false;
}

bool WakeUp::Sleep(nanoseconds duration) {
  if (Consume()) return true;
  if (duration <= nanoseconds::zero()) return false;
  const bool for_ever = duration == nanoseconds::max();
  const timespec deadline = for_ever ? timespec{} : Deadline(duration);
  std::uint32_t expected = kQuiet;
  if (!state_.compare_exchange_strong(expected, kAsleep, std::memory_order_acq_rel)) {
    return Consume();
  }
  // With a bit set, the time is a point of CLOCK_MONOTONIC, so being interrupted costs nothing.
  while (state_.load(std::memory_order_acquire) == kAsleep) {
    const long result = syscall(SYS_futex, &state_, FUTEX_WAIT_BITSET_PRIVATE, kAsleep,
                                for_ever ? nullptr : &deadline, nullptr, FUTEX_BITSET_MATCH_ANY);
    if (result == -1 && errno == ETIMEDOUT) break;
  }
  return Consume();
}

}  // namespace coppice
