#include "robot_app/simulation/drive.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::simulation {
namespace {

constexpr double kFar = 100;
constexpr double kDt = 0.02;

// Drives freely for `seconds`, giving `command` anew each step; returns the velocity at the end.
Velocity DriveFreely(Drive& drive, const Velocity& command, double seconds) {
  Velocity actual;
  for (double t = 0; t < seconds - 1e-9; t += kDt) {
    drive.Command(t, command);
    actual = drive.Next(t, kDt, actual, kFar, true);
  }
  return actual;
}

TEST(Drive, AcceleratesWithinItsLimits) {
  Drive drive;
  const Velocity half = DriveFreely(drive, {5, 5}, 0.5);
  EXPECT_NEAR(half.linear, 0.3, 1e-9);
  EXPECT_NEAR(half.angular, 0.75, 1e-9);
  const Velocity end = DriveFreely(drive, {5, -5}, 3);
  EXPECT_NEAR(end.linear, 0.9, 1e-9);
  EXPECT_NEAR(end.angular, -1.2, 1e-9);
}

TEST(Drive, StopsHalfASecondAfterTheLastCommand) {
  Drive drive;
  drive.Command(10, {0.5, 0});
  EXPECT_DOUBLE_EQ(drive.Next(10.5, kDt, {0.5, 0}, kFar, true).linear, 0.5);
  EXPECT_LT(drive.Next(10.52, kDt, {0.5, 0}, kFar, true).linear, 0.5);
}

TEST(Drive, IgnoresACommandThatIsNoNumber) {
  Drive drive;
  drive.Command(0, {std::nan(""), INFINITY});
  const Velocity next = drive.Next(0, kDt, {}, kFar, true);
  EXPECT_EQ(next.linear, 0);
  EXPECT_EQ(next.angular, 0);
}

TEST(Drive, DoesNotMoveWithAnEmptyBattery) {
  Drive drive;
  drive.Command(0, {0.5, 0.5});
  EXPECT_EQ(drive.Next(0, kDt, {}, kFar, false).linear, 0);
}

TEST(Drive, CutsForwardVelocityWhenSomethingIsAtTheFront) {
  Drive drive;
  drive.Command(0, {0.5, 0.5});
  const Velocity next = drive.Next(0, kDt, {0.3, 0.2}, 0.04, true);
  EXPECT_EQ(next.linear, 0);
  EXPECT_GT(next.angular, 0.2);  // turning away stays possible
  EXPECT_TRUE(drive.protective_stop());
}

TEST(Drive, LetsTheRobotBackOutOfTheProtectiveField) {
  Drive drive;
  drive.Command(0, {-0.5, 0});
  EXPECT_LT(drive.Next(0, kDt, {}, 0.01, true).linear, 0);
  EXPECT_FALSE(drive.protective_stop());
}

TEST(Drive, NeedsMoreSpaceTheFasterItIs) {
  const Drive drive;
  EXPECT_DOUBLE_EQ(drive.ProtectiveField(0), 0.05);
  EXPECT_DOUBLE_EQ(drive.ProtectiveField(-1), 0.05);
  EXPECT_GT(drive.ProtectiveField(0.9), drive.ProtectiveField(0.5));
  Drive fast;
  fast.Command(0, {0.9, 0});
  Velocity actual{0.9, 0};
  double gap = 1;
  for (double t = 0; t < 3; t += kDt) {
    fast.Command(t, {0.9, 0});
    actual = fast.Next(t, kDt, actual, gap, true);
    gap -= actual.linear * kDt;
  }
  EXPECT_GT(gap, 0.03);
  EXPECT_LT(gap, 0.15);
}

}  // namespace
}  // namespace coppice::robot::simulation
