#include "robot_app/perception/legs/scan_segments.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/robot_app/perception/legs/made_scan.h"

namespace coppice::robot::perception {
namespace {

SegmentedScan Segmented(const LaserScan& scan, double farthest = 8) {
  SegmentedScan segmented;
  SegmentByJumps(scan, farthest, segmented);
  return segmented;
}

TEST(ScanSegments, TwoLegsBeforeAWallAreTwoSegmentsAndTheWallIsCutByThem) {
  const SegmentedScan scan = Segmented(ScanOf(LegsAt(2, 0)));
  // the wall to the right, a leg, the wall between both, a leg, the wall to the left
  ASSERT_EQ(scan.segments.size(), 5U);
  EXPECT_NEAR(scan.points[scan.segments[1].begin].at.x(), 2, 0.1);
  EXPECT_NEAR(scan.points[scan.segments[3].begin].at.x(), 2, 0.1);
}

TEST(ScanSegments, ALegHasJumpsBackAtBothEnds) {
  const SegmentedScan scan = Segmented(ScanOf({{{2, 0}, 0.075}}));
  ASSERT_EQ(scan.segments.size(), 3U);
  EXPECT_EQ(scan.segments[1].jump_before, 2);  // no farther is told
  EXPECT_EQ(scan.segments[1].jump_after, 2);
  EXPECT_LT(scan.segments[0].jump_after, 0);
}

TEST(ScanSegments, WhatIsFartherThanAskedForIsLeftOut) {
  const SegmentedScan scan = Segmented(ScanOf({{{2, 0}, 0.075}}), 4);
  ASSERT_EQ(scan.segments.size(), 1U);
  EXPECT_EQ(scan.segments[0].jump_after, 2);
}

TEST(ScanSegments, WhatABeamDoesNotTellIsNoJump) {
  LaserScan scan = ScanOf({{{2, 0}, 0.075}});
  const SegmentedScan whole = Segmented(scan, 4);
  scan.ranges[whole.points.back().beam + 1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(Segmented(scan, 4).segments[0].jump_after, 0);
}

TEST(ScanSegments, AnEmptyScanHasNone) { EXPECT_TRUE(Segmented(LaserScan{}).segments.empty()); }

}  // namespace
}  // namespace coppice::robot::perception
