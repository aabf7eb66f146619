#include "bt_core/base/clock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <type_traits>
#include <utility>

namespace coppice {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

template <class A, class B, class = void>
constexpr bool kCanBeAdded = false;
template <class A, class B>
constexpr bool kCanBeAdded<A, B, std::void_t<decltype(std::declval<A>() + std::declval<B>())>> =
    true;
static_assert(kCanBeAdded<Time, Duration>);
static_assert(!kCanBeAdded<Time, Time>);
static_assert(std::is_same_v<decltype(Time() - Time()), Duration>);
static_assert(!std::is_convertible_v<Duration, Time>);
static_assert(!std::is_convertible_v<Time, Duration>);
static_assert(!std::is_constructible_v<Time, WallTime>);
static_assert(!std::is_constructible_v<WallTime, Time>);
static_assert(sizeof(Time) == sizeof(std::int64_t));

TEST(SimulatedClock, StandsStillUntilItIsMoved) {
  SimulatedClock clock(seconds(5));
  EXPECT_EQ(clock.Now(), Time(seconds(5)));
  EXPECT_EQ(clock.Now(), Time(seconds(5)));
  clock.Advance(milliseconds(3));
  EXPECT_EQ(clock.Now(), Time(seconds(5) + milliseconds(3)));
}

TEST(SimulatedClock, WaitingJumpsToTheDeadline) {
  SimulatedClock clock;
  WakeUp wake_up;
  clock.WaitUntil(Time(seconds(3600)), wake_up);
  EXPECT_EQ(clock.Now(), Time(seconds(3600)));
}

TEST(SimulatedClock, NeverGoesBack) {
  SimulatedClock clock(seconds(10));
  WakeUp wake_up;
  clock.WaitUntil(Time(seconds(4)), wake_up);
  EXPECT_EQ(clock.Now(), Time(seconds(10)));
}

TEST(SimulatedClock, AWakeUpEndsTheWaitBeforeTimeMoves) {
  SimulatedClock clock;
  WakeUp wake_up;
  wake_up.Notify();
  clock.WaitUntil(Time(seconds(1)), wake_up);
  EXPECT_EQ(clock.Now(), Time(seconds(0)));
}

TEST(SimulatedClock, WithoutDeadlineItWaitsForTheWakeUp) {
  SimulatedClock clock(seconds(1));
  WakeUp wake_up;
  std::thread notifier([&] { wake_up.Notify(); });
  clock.WaitUntil(kNever, wake_up);
  notifier.join();
  EXPECT_EQ(clock.Now(), Time(seconds(1)));
}

TEST(WallClock, CountsFrom1970) {
  const Time system(std::chrono::system_clock::now().time_since_epoch());
  const Time now = WallClock().Now();
  EXPECT_GE(now, system - seconds(1));
  EXPECT_LE(now, system + seconds(60));
}

TEST(WallClock, WaitsUntilTheDeadline) {
  WallClock clock;
  WakeUp wake_up;
  const Time deadline = clock.Now() + milliseconds(5);
  while (clock.Now() < deadline) clock.WaitUntil(deadline, wake_up);
  EXPECT_GE(clock.Now(), deadline);
}

TEST(WallClock, DoesNotWaitForADeadlineInThePast) {
  WallClock clock;
  WakeUp wake_up;
  wake_up.Notify();
  clock.WaitUntil(clock.Now() - seconds(1), wake_up);
  EXPECT_TRUE(wake_up.WaitFor(seconds(0))) << "the wake-up must still be there";
}

TEST(WallClock, AWakeUpEndsTheWait) {
  WallClock clock;
  WakeUp wake_up;
  wake_up.Notify();
  const Time deadline = clock.Now() + seconds(30);
  clock.WaitUntil(deadline, wake_up);
  EXPECT_LT(clock.Now(), deadline);
}

}  // namespace
}  // namespace coppice
