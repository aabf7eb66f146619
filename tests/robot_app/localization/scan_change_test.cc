#include "robot_app/localization/scan_change.h"

#include <gtest/gtest.h>

#include "tests/robot_app/navigation/test_floor.h"

namespace coppice::robot::localization {
namespace {

using navigation::EmptyRoom;
using navigation::ScanOf;

constexpr Pose2D kHere{2, 2.5, 0};

TEST(ScanChange, IsNothingWhileNothingHappens) {
  const OccupancyGrid room = EmptyRoom(10, 5);
  ScanChange change;
  EXPECT_EQ(change.Add(ScanOf(room, kHere, 1), {}), 0);
  EXPECT_EQ(change.Add(ScanOf(room, kHere, 1.1), {}), 0);
}

TEST(ScanChange, IsLargeWhenTheRobotIsElsewhereAtOnce) {
  const OccupancyGrid room = EmptyRoom(10, 5);
  ScanChange change;
  change.Add(ScanOf(room, kHere, 1), {});
  EXPECT_GT(change.Add(ScanOf(room, {5, 2.5, 0}, 1.1), {}), 0.1);
  EXPECT_EQ(change.Add(ScanOf(room, {5, 2.5, 0}, 1.2), {}), 0);
}

TEST(ScanChange, DoesNotCountTheRobotsOwnMotion) {
  const OccupancyGrid room = EmptyRoom(10, 5);
  ScanChange change;
  Pose2D pose = kHere;
  change.Add(ScanOf(room, pose, 1), pose);
  for (int i = 1; i < 30; ++i) {
    pose = Compose(pose, {0.07, 0, 0.1});
    EXPECT_LT(change.Add(ScanOf(room, pose, 1 + 0.1 * i), pose), 0.02) << i;
  }
}

TEST(ScanChange, IsSmallWhenAPersonWalksBy) {
  ScanChange change;
  for (int i = 0; i < 30; ++i) {
    OccupancyGrid room = EmptyRoom(10, 5);
    const double y = 1 + 0.1 * i;  // 1 m/s
    navigation::Fill(room, {3.5, y}, {4, y + 0.5});
    EXPECT_LT(change.Add(ScanOf(room, kHere, 1 + 0.1 * i), {}), 0.07) << i;
  }
}

TEST(ScanChange, ComparesOnlyWhatCompares) {
  const OccupancyGrid room = EmptyRoom(10, 5);
  const Pose2D there{5, 2.5, 0};
  ScanChange change;
  change.Add(ScanOf(room, kHere, 1), {});
  EXPECT_EQ(change.Add(ScanOf(room, there, 1.4), {}), 0) << "people had time to go";
  change.Clear();
  EXPECT_EQ(change.Add(ScanOf(room, kHere, 1.5), {}), 0) << "another odometry";
  EXPECT_EQ(change.Add(ScanOf(room, there, 1.6), {0.3, 0, 0}), 0) << "it has driven on";
  LaserScan other = ScanOf(room, there, 1.7);
  other.ranges.resize(100);
  EXPECT_EQ(change.Add(other, {}), 0) << "another scanner";
  other.ranges.assign(100, NAN);
  EXPECT_EQ(change.Add(other, {}), 0);
}

}  // namespace
}  // namespace coppice::robot::localization
