#include "robot_app/teleoperation/teleoperation.h"

#include <gtest/gtest.h>

#include <limits>

namespace coppice::robot::teleoperation {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class Wheel : public testing::Test {
 protected:
  Wheel() { wheel_.SetObstacles({}, now_); }

  Velocity2D After(Duration duration) {
    return wheel_.Command(now_ + duration).value_or(Velocity2D{99, 99});
  }

  Teleoperation wheel_{TeleoperationSettings{}};
  Time now_{seconds(1000)};
};

TEST_F(Wheel, WithoutADriverNothingIsSaid) {
  EXPECT_FALSE(wheel_.Command(now_));
  wheel_.Drive(1, {0.2, 0}, now_, now_);
  EXPECT_FALSE(wheel_.Command(now_));
}

TEST_F(Wheel, AWishCountsForThreeTenthsOfASecond) {
  wheel_.Take(1, "Ada", false, now_);
  wheel_.Drive(1, {0.2, 0.1}, now_, now_);
  EXPECT_EQ(After(milliseconds(299)).linear, 0.2);
  EXPECT_EQ(After(milliseconds(300)).linear, 0);
  EXPECT_EQ(After(milliseconds(300)).angular, 0);
}

TEST_F(Wheel, TheServerLimitsTheSpeed) {
  wheel_.Take(1, "Ada", false, now_);
  wheel_.Drive(1, {100, -100}, now_, now_);
  EXPECT_EQ(After(milliseconds(0)).linear, 0.4);
  EXPECT_EQ(After(milliseconds(0)).angular, -0.8);
  wheel_.Drive(1, {std::numeric_limits<double>::quiet_NaN(), 0.1}, now_, now_);
  EXPECT_EQ(After(milliseconds(0)).linear, 0);
}

TEST_F(Wheel, OnlyOnePersonDrivesUnlessAnotherTakesOver) {
  EXPECT_TRUE(wheel_.Take(1, "Ada", false, now_));
  EXPECT_FALSE(wheel_.Take(2, "Ben", false, now_));
  wheel_.Drive(1, {0.2, 0}, now_, now_);
  EXPECT_TRUE(wheel_.Take(2, "Ben", true, now_));
  EXPECT_EQ(wheel_.driver_name(), "Ben");
  EXPECT_EQ(After(milliseconds(0)).linear, 0);
  wheel_.Drive(1, {0.2, 0}, now_, now_);
  EXPECT_EQ(After(milliseconds(0)).linear, 0);
}

TEST_F(Wheel, WhoLeavesOrIsIdleGivesTheWheelBack) {
  wheel_.Take(1, "Ada", false, now_);
  wheel_.Leave(2);
  EXPECT_EQ(wheel_.driver(), 1u);
  wheel_.Leave(1);
  EXPECT_EQ(wheel_.driver(), 0u);
  wheel_.Take(1, "Ada", false, now_);
  wheel_.Command(now_ + seconds(29));
  EXPECT_EQ(wheel_.driver(), 1u);
  wheel_.Command(now_ + seconds(30));
  EXPECT_EQ(wheel_.driver(), 0u);
}

TEST_F(Wheel, WhoLeavesStopsTheRobotWithOneZero) {
  wheel_.Take(1, "Ada", false, now_);
  wheel_.Drive(1, {0.2, 0.1}, now_, now_);
  wheel_.Leave(1);
  EXPECT_EQ(After(milliseconds(0)).linear, 0);
  EXPECT_FALSE(wheel_.Command(now_));
}

TEST_F(Wheel, AWishThatWasHalfASecondOnItsWayIsOneToStop) {
  wheel_.Take(1, "Ada", false, now_);
  wheel_.Drive(1, {0.2, 0.1}, now_ - milliseconds(500), now_);
  EXPECT_EQ(After(milliseconds(0)).linear, 0.2);
  wheel_.Drive(1, {0.2, 0.1}, now_ - milliseconds(501), now_);
  EXPECT_EQ(After(milliseconds(0)).linear, 0);
  EXPECT_EQ(After(milliseconds(0)).angular, 0);
  EXPECT_EQ(wheel_.held(), "The connection is too slow to drive.");
  wheel_.Drive(1, {0.2, 0.1}, now_ + milliseconds(1), now_);
  EXPECT_EQ(After(milliseconds(0)).linear, 0) << "nobody has heard that beat yet";
}

TEST_F(Wheel, AnObstacleHoldsTheRobotAndThePersonIsTold) {
  wheel_.Take(1, "Ada", false, now_);
  wheel_.SetObstacles({{0.5, 0}}, now_);
  wheel_.Drive(1, {0.3, 0.2}, now_, now_);
  EXPECT_EQ(After(milliseconds(0)).linear, 0);
  EXPECT_EQ(After(milliseconds(0)).angular, 0.2);
  EXPECT_EQ(wheel_.held(), "Something stands in the way.");
}

TEST_F(Wheel, WithoutAFreshScanTheRobotOnlyTurns) {
  wheel_.Take(1, "Ada", false, now_);
  wheel_.Drive(1, {0.3, 0.2}, now_ + seconds(1), now_ + seconds(1));
  EXPECT_EQ(After(seconds(1)).linear, 0);
  EXPECT_EQ(After(seconds(1)).angular, 0.2);
}

}  // namespace
}  // namespace coppice::robot::teleoperation
