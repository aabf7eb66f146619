#include "robot_app/common/range_reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace coppice::robot {
namespace {

using testing::HasSubstr;

RangeReading Reading(double range) {
  RangeReading reading;
  reading.range = range;
  return reading;
}

TEST(RangeReading, TellsAnEchoWithinItsLimits) {
  EXPECT_TRUE(Check(Reading(0.2)));
  EXPECT_TRUE(Check(Reading(4)));
  EXPECT_TRUE(Reading(4).Hit());
}

TEST(RangeReading, InfinityIsNoEchoAndMinusInfinityOneThatIsTooNear) {
  EXPECT_TRUE(Check(Reading(HUGE_VAL)));
  EXPECT_TRUE(Reading(HUGE_VAL).MetNothing());
  EXPECT_TRUE(Check(Reading(-HUGE_VAL)));
  EXPECT_TRUE(Reading(-HUGE_VAL).TooNear());
}

TEST(RangeReading, ARangeThatIsNoNumberTellsNothing) {
  EXPECT_THAT(Check(Reading(std::nan(""))).problem(), HasSubstr("not a number"));
}

TEST(RangeReading, ARangeOutsideTheLimitsTellsNothing) {
  for (const double range : {-1.0, 0.0, 0.19, 4.01, 1e300}) {
    EXPECT_THAT(Check(Reading(range)).problem(), HasSubstr("limits")) << range;
  }
}

TEST(RangeReading, LimitsMustBeThoseOfASensor) {
  const double nan = std::nan("");
  using Limits = std::pair<double, double>;
  for (const auto& [low, high] :
       {Limits(-1, 4), {2, 1}, {1, 1}, {0, HUGE_VAL}, {nan, 4}, {0, nan}}) {
    RangeReading reading = Reading(HUGE_VAL);
    reading.min_range = low;
    reading.max_range = high;
    EXPECT_FALSE(Check(reading)) << low << ", " << high;
  }
}

TEST(RangeReading, AConeMustBeOne) {
  for (const double angle : {0.0, -1.0, 7.0, std::nan("")}) {
    RangeReading reading = Reading(1);
    reading.field_of_view = angle;
    EXPECT_THAT(Check(reading).problem(), HasSubstr("field of view")) << angle;
  }
}

}  // namespace
}  // namespace coppice::robot
