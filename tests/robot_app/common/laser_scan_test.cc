#include "robot_app/common/laser_scan.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot {
namespace {

TEST(LaserScan, PointsAreGivenInBaseLink) {
  LaserScan scan;
  scan.mount = {0.25, 0, 0};
  scan.angle_min = -M_PI / 2;
  scan.angle_increment = M_PI / 2;
  scan.ranges = {1, 2, 3};
  const auto points = PointsInBase(scan, 10);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_NEAR(points[0].x, 0.25, 1e-9);
  EXPECT_NEAR(points[0].y, -1, 1e-9);
  EXPECT_NEAR(points[1].x, 2.25, 1e-9);
  EXPECT_NEAR(points[2].y, 3, 1e-9);
}

TEST(LaserScan, ReadingsThatAreNoEchoGiveNoPoints) {
  LaserScan scan;
  scan.ranges = {INFINITY, NAN, 0.01F, 25.0F, 4.0F};
  EXPECT_TRUE(PointsInBase(scan, 3).empty());
  EXPECT_EQ(PointsInBase(scan, 5).size(), 1u);
}

LaserScan ScanOf(std::vector<float> ranges) {
  LaserScan scan;
  scan.ranges = std::move(ranges);
  return scan;
}

TEST(LaserScan, AHitAndNothingWithinRangeAreAnswersOfWhichHalfTheBeamsMustGiveOne) {
  EXPECT_TRUE(IsUsable(ScanOf({1, 2, INFINITY, 25})));
  EXPECT_TRUE(IsUsable(ScanOf({INFINITY, INFINITY})));
  EXPECT_TRUE(IsUsable(ScanOf({1, INFINITY, NAN, NAN})));
  EXPECT_FALSE(IsUsable(ScanOf({1, NAN, NAN, NAN})));
}

TEST(LaserScan, WithoutAnAnswerItIsNoFreeWay) {
  EXPECT_FALSE(IsUsable(ScanOf({})));
  for (const float nothing : {NAN, -INFINITY, 0.0F, -1.0F}) {
    EXPECT_FALSE(IsUsable(ScanOf({nothing, nothing, nothing}))) << nothing;
  }
}

TEST(LaserScan, WithoutDirectionsOrARangeItsBeamsSayNothing) {
  for (double LaserScan::*const field :
       {&LaserScan::angle_min, &LaserScan::angle_increment, &LaserScan::range_max}) {
    LaserScan scan = ScanOf({1, 2, 3});
    scan.*field = NAN;
    EXPECT_FALSE(IsUsable(scan));
  }
}

}  // namespace
}  // namespace coppice::robot
