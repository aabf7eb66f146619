// Waiting for what another thread or process does: as soon as it has come true, with a deadline
// that only a failure reaches, also on a computer that is very busy.
#ifndef COPPICE_TESTS_ROBOT_APP_EVENTUALLY_H_
#define COPPICE_TESTS_ROBOT_APP_EVENTUALLY_H_

#include <chrono>
#include <functional>
#include <thread>

namespace coppice::robot {

/// Times as long, under what makes programs so much slower.
#ifdef __SANITIZE_THREAD__
inline constexpr double kSlowness = 6;
#else
inline constexpr double kSlowness = 1;
#endif

/// Looks again and again, at most that long in real time, whether something has come true.
inline bool Eventually(const std::function<bool()>& predicate, double seconds = 60) {
  const auto deadline =
      std::chrono::steady_clock::now() + std::chrono::duration<double>(kSlowness * seconds);
  while (!predicate()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_ROBOT_APP_EVENTUALLY_H_
