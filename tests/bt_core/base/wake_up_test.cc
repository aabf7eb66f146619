#include "bt_core/base/wake_up.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

namespace coppice {
namespace {

using std::chrono::seconds;

TEST(WakeUp, TimesOutWithoutNotification) {
  WakeUp wake_up;
  EXPECT_FALSE(wake_up.WaitFor(std::chrono::nanoseconds(0)));
}

TEST(WakeUp, ANotificationBeforeTheWaitIsNotLost) {
  WakeUp wake_up;
  wake_up.Notify();
  EXPECT_TRUE(wake_up.WaitFor(seconds(0)));
}

TEST(WakeUp, SeveralNotificationsEndOneWait) {
  WakeUp wake_up;
  wake_up.Notify();
  wake_up.Notify();
  EXPECT_TRUE(wake_up.WaitFor(seconds(0)));
  EXPECT_FALSE(wake_up.WaitFor(seconds(0)));
}

TEST(WakeUp, WaitsForEverWithoutALimit) {
  WakeUp wake_up;
  std::thread notifier([&] { wake_up.Notify(); });
  EXPECT_TRUE(wake_up.WaitFor(std::chrono::nanoseconds::max()));
  notifier.join();
}

TEST(WakeUp, ShowsWhatWasWrittenBefore) {
  WakeUp wake_up;
  int written = 0;
  std::thread notifier([&] {
    written = 5;
    wake_up.Notify();
  });
  while (!wake_up.WaitFor(seconds(1))) {
  }
  EXPECT_EQ(written, 5);
  notifier.join();
}

TEST(WakeUp, IsNotLostWhileTheWaiterLooksOut) {
  constexpr int kRounds = 5000;
  WakeUp ping;
  WakeUp pong;
  ping.set_lookout(std::chrono::microseconds(50));
  pong.set_lookout(std::chrono::microseconds(50));
  std::thread other([&] {
    for (int i = 0; i < kRounds; ++i) {
      EXPECT_TRUE(ping.WaitFor(seconds(10)));
      pong.Notify();
    }
  });
  for (int i = 0; i < kRounds; ++i) {
    ping.Notify();
    EXPECT_TRUE(pong.WaitFor(seconds(10)));
  }
  other.join();
}

TEST(WakeUp, ALookoutEndsWithTheWait) {
  WakeUp wake_up;
  wake_up.set_lookout(std::chrono::hours(1));
  EXPECT_FALSE(wake_up.WaitFor(std::chrono::microseconds(10)));
  wake_up.Notify();
  EXPECT_TRUE(wake_up.WaitFor(std::chrono::hours(1)));
}

TEST(WakeUp, NotifyMayBeCalledFromASignalHandler) {
  static WakeUp wake_up;
  std::signal(SIGUSR1, [](int) { wake_up.Notify(); });
  const pthread_t waiter = pthread_self();
  std::thread sender([waiter] { pthread_kill(waiter, SIGUSR1); });
  EXPECT_TRUE(wake_up.WaitFor(seconds(30)));
  sender.join();
  std::signal(SIGUSR1, SIG_DFL);
}

// Two threads hand a token back and forth; a lost wake-up would let a wait run out.
TEST(WakeUp, IsNeverLostBetweenThreads) {
  constexpr int kRounds = 5000;
  WakeUp ping;
  WakeUp pong;
  std::atomic<int> lost{0};
  std::thread other([&] {
    for (int i = 0; i < kRounds; ++i) {
      if (!ping.WaitFor(seconds(10))) ++lost;
      pong.Notify();
    }
  });
  for (int i = 0; i < kRounds; ++i) {
    ping.Notify();
    if (!pong.WaitFor(seconds(10))) ++lost;
  }
  other.join();
  EXPECT_EQ(lost, 0);
}

}  // namespace
}  // namespace coppice
