#include "robot_app/monitoring/system/counter_rate.h"

#include <gtest/gtest.h>

namespace coppice::robot::monitoring {
namespace {

using std::chrono::seconds;

TEST(CounterRate, IsTheGrowthPerSecondWithinTheWindow) {
  CounterRate rate(seconds(4));
  EXPECT_FALSE(rate.OnReading(1000, Time(seconds(10))).has_value());
  EXPECT_EQ(rate.OnReading(1020, Time(seconds(12))), 10);
  EXPECT_EQ(rate.OnReading(1040, Time(seconds(14))), 10);
  EXPECT_EQ(rate.OnReading(1040, Time(seconds(16))), 5);
  EXPECT_EQ(rate.OnReading(1040, Time(seconds(18))), 0);
}

TEST(CounterRate, AGapInTheReadingsIsBridged) {
  CounterRate rate(seconds(4));
  rate.OnReading(0, Time(seconds(10)));
  EXPECT_EQ(rate.OnReading(100, Time(seconds(110))), 1);
}

TEST(CounterRate, ACounterThatBeginsAnewIsNoGrowth) {
  CounterRate rate(seconds(4));
  rate.OnReading(1000, Time(seconds(10)));
  EXPECT_FALSE(rate.OnReading(5, Time(seconds(12))).has_value());
  EXPECT_EQ(rate.OnReading(25, Time(seconds(14))), 10);
  EXPECT_FALSE(rate.OnReading(30, Time(seconds(1))).has_value());  // time jumped back
  EXPECT_FALSE(rate.OnReading(40, Time(seconds(1))).has_value());  // no time has passed
}

}  // namespace
}  // namespace coppice::robot::monitoring
