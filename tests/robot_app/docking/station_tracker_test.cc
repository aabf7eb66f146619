#include "robot_app/docking/station_tracker.h"

#include <gtest/gtest.h>

#include "tests/robot_app/docking/station_scans.h"

namespace coppice::robot::docking {
namespace {

constexpr Pose2D kBase{-0.8, 0, M_PI};  // before the station

class StationTrackerTest : public testing::Test {
 protected:
  void Look(int scans, const Pose2D& base, const std::vector<simulation::Disc>& discs = {}) {
    for (int i = 0; i < scans; ++i) {
      LaserScan scan = scans_.From(base, discs);
      scan.stamp = 0.1 * ++time_;
      tracker_.AddScan(scan, base, expected_);
    }
  }
  double Error() const { return Distance(tracker_.seen()->docked, station_); }

  simulation::Floor floor_ = navigation::InstituteFloor();
  Pose2D station_{floor_.docked.x, floor_.docked.y, floor_.docked.yaw};
  StationScans scans_{floor_};
  StationTracker tracker_;
  std::optional<Pose2D> expected_;
  int time_ = 0;
};

TEST_F(StationTrackerTest, AFewScansAreEnough) {
  Look(1, kBase);
  EXPECT_FALSE(tracker_.seen());
  Look(9, kBase);
  ASSERT_TRUE(tracker_.seen());
  EXPECT_LT(Error(), 0.02);
}

TEST_F(StationTrackerTest, ManyScansMeasureBetterThanOne) {
  Look(60, {-1.4, 0.1, M_PI});
  ASSERT_TRUE(tracker_.seen());
  EXPECT_LT(Error(), 0.006);
}

TEST_F(StationTrackerTest, WhatIsHiddenIsRemembered) {
  Look(10, kBase);
  Look(40, kBase, {{{-1.4, 0}, 0.3}});
  ASSERT_TRUE(tracker_.seen());
  EXPECT_LT(Error(), 0.02);
  EXPECT_LT(tracker_.seen()->stamp, 1.2);
}

TEST_F(StationTrackerTest, ALandmarkFarFromWhereTheStationIsExpectedIsAnother) {
  expected_ = Pose2D{10, 0, M_PI};
  Look(20, kBase);
  EXPECT_FALSE(tracker_.seen());
}

TEST_F(StationTrackerTest, ForgetsWhenItIsTold) {
  Look(10, kBase);
  tracker_.Reset();
  EXPECT_FALSE(tracker_.seen());
}

}  // namespace
}  // namespace coppice::robot::docking
