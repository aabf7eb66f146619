#include "robot_app/simulation/pace.h"

#include <gtest/gtest.h>

namespace coppice::robot::simulation {
namespace {

constexpr double kStep = 0.02;

TEST(Pace, IsWhatWasAskedForWhileTheRobotKeepsUp) {
  Pace pace(4);
  EXPECT_DOUBLE_EQ(pace.Seconds(kStep, 1000, 0), kStep / 4);
  pace.Heard("odom", 1000.0, 0.1);
  EXPECT_DOUBLE_EQ(pace.Seconds(kStep, 1000.2, 0.2), kStep / 4);
}

TEST(Pace, IsRealTimeWhileSomethingOfTheRobotIsLate) {
  Pace pace(4);
  pace.Heard("odom", 1000.4, 0.1);
  pace.Heard("map", 1000.0, 0.1);
  EXPECT_DOUBLE_EQ(pace.Seconds(kStep, 1000.5, 0.2), kStep);
  pace.Heard("map", 1000.4, 0.3);
  EXPECT_DOUBLE_EQ(pace.Seconds(kStep, 1000.5, 0.3), kStep / 4);
}

TEST(Pace, DoesNotWaitForWhoHasDied) {
  Pace pace(4);
  pace.Heard("odom", 1000, 0);
  EXPECT_DOUBLE_EQ(pace.Seconds(kStep, 1001, 1), kStep);
  EXPECT_DOUBLE_EQ(pace.Seconds(kStep, 1002, 3), kStep / 4);
}

TEST(Pace, AsFastAsPossibleWaitsForWhoIsLateOnly) {
  Pace pace(0);
  EXPECT_DOUBLE_EQ(pace.Seconds(kStep, 1000, 0), 0);
  pace.Heard("odom", 1000, 0);
  EXPECT_DOUBLE_EQ(pace.Seconds(kStep, 1001, 1), kStep);
}

TEST(Pace, IsAnotherOneFromThenOnThatItIsTold) {
  Pace pace(4);
  EXPECT_TRUE(pace.is_fast());
  pace.set_speed(0.5);
  EXPECT_FALSE(pace.is_fast());
  EXPECT_DOUBLE_EQ(pace.Seconds(kStep, 1000, 0), kStep / 0.5);
  pace.set_speed(0);
  EXPECT_TRUE(pace.is_fast());
}

TEST(Pace, IsNeverFasterThanWasAskedFor) {
  Pace pace(0.5);
  pace.Heard("odom", 1000, 0);
  EXPECT_DOUBLE_EQ(pace.Seconds(kStep, 1001, 1), kStep / 0.5);
}

}  // namespace
}  // namespace coppice::robot::simulation
