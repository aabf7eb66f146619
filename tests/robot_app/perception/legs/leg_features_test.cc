#include "robot_app/perception/legs/leg_features.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/robot_app/perception/legs/made_scan.h"

namespace coppice::robot::perception {
namespace {

constexpr int kWidth = 1, kOffLine = 6, kOffCircle = 7, kRadius = 8, kDistance = 13;

SegmentedScan Segmented(const LaserScan& scan) {
  SegmentedScan segmented;
  SegmentByJumps(scan, 4, segmented);
  return segmented;
}

TEST(LegFeatures, ALegIsRoundWithItsRadius) {
  const LegFeatures features = Describe(Segmented(ScanOf({{{1.5, 0}, 0.075}})), {0, {}});
  EXPECT_NEAR(features[kRadius], 0.075, 0.005);
  EXPECT_LT(features[kOffCircle], 0.002);
  EXPECT_GT(features[kOffLine], 0.01);
  EXPECT_NEAR(features[kWidth], 0.15, 0.03);
  EXPECT_NEAR(features[kDistance], 1.44, 0.03);
}

TEST(LegFeatures, AWallIsStraight) {
  SegmentedScan scan;
  SegmentByJumps(ScanOf({}), 8, scan);
  const LegFeatures features = Describe(scan, {0, {}});
  EXPECT_LT(features[kOffLine], 0.001);
  EXPECT_EQ(features[kRadius], 1);  // no larger is told
}

TEST(LegFeatures, OfTwoLegsTheNearerComesFirstWhicheverIsNamedFirst) {
  const SegmentedScan scan = Segmented(ScanOf({{{2, 0.2}, 0.075}, {{1.6, -0.2}, 0.075}}));
  ASSERT_EQ(scan.segments.size(), 2U);
  const LegFeatures features = Describe(scan, {0, 1});
  EXPECT_EQ(features, Describe(scan, {1, 0}));
  EXPECT_LT(features[kDistance], features[kSegmentFeatures + kDistance]);
  EXPECT_NEAR(features[2 * kSegmentFeatures], std::hypot(0.4, 0.4), 0.03);
}

TEST(LegFeatures, ASinglePointIsDescribedWithNumbers) {
  LaserScan scan = ScanOf({});
  scan.ranges.assign(scan.ranges.size(), 20);
  scan.ranges[270] = 2;
  for (const float feature : Describe(Segmented(scan), {0, {}})) {
    EXPECT_TRUE(std::isfinite(feature));
  }
}

}  // namespace
}  // namespace coppice::robot::perception
