#include "robot_app/perception/legs/leg_finder.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/robot_app/perception/legs/made_scan.h"
#include "tests/support/folders.h"

namespace coppice::robot::perception {
namespace {

LegFinder Shipped() {
  auto classifier =
      LegClassifier::Load(SourceFolder() + "/robot_app/perception/data/legs_in_scans.yaml");
  EXPECT_TRUE(classifier) << classifier.problem();
  return {{}, std::move(*classifier)};
}

TEST(LegFinder, WhoStandsBeforeTheLaserIsOnePersonBetweenTheLegs) {
  LegFinder finder = Shipped();
  const auto people = finder.Find(ScanOf(LegsAt(2, 0.5), 0.01));
  ASSERT_EQ(people.size(), 1U);
  EXPECT_NEAR(people[0].position.x(), 2, 0.05);
  EXPECT_NEAR(people[0].position.y(), 0.5, 0.05);
  EXPECT_TRUE(people[0].legs.second);
}

TEST(LegFinder, OfWhoShowsOneLegThePlaceIsLessSure) {
  LegFinder finder = Shipped();
  const auto both = finder.Find(ScanOf(LegsAt(2, 0), 0.01));
  ASSERT_EQ(both.size(), 1U);
  const float sure = both[0].covariance(0, 0);
  const auto one = finder.Find(ScanOf({{{2, 0}, 0.075}}, 0.01));
  ASSERT_EQ(one.size(), 1U);
  EXPECT_GT(one[0].covariance(0, 0), 2 * sure);
}

TEST(LegFinder, TwoWhoMeetAreTwo) {
  std::vector<simulation::Disc> legs = LegsAt(2, 0.5);
  for (const simulation::Disc& leg : LegsAt(2, -0.3)) legs.push_back(leg);
  EXPECT_EQ(Shipped().Find(ScanOf(legs, 0.01)).size(), 2U);
}

TEST(LegFinder, AWallAndAColumnAreNobody) {
  EXPECT_TRUE(Shipped().Find(ScanOf({{{3, 0}, 0.3}}, 0.01)).empty());
}

TEST(LegFinder, AScanOfManySmallThingsDoesNotTakeForEver) {
  LaserScan scan;
  scan.angle_min = -3;
  scan.angle_increment = 6.0 / 9000;
  for (int i = 0; i < 9000; ++i) scan.ranges.push_back(i % 4 < 2 ? 0.5F : 0.9F);
  SegmentedScan segmented;
  SegmentByJumps(scan, 8, segmented);
  EXPECT_LT(LegCandidatesIn(segmented).size(), 10 * segmented.segments.size());
}

TEST(LegFinder, WhatIsBehindOrBesideOrFarIsHidden) {
  const LaserScan scan = ScanOf({{{2, 0}, 0.075}});
  EXPECT_FALSE(IsHidden(scan, 8, {1, 0}));
  EXPECT_FALSE(IsHidden(scan, 8, {2, 0}));
  EXPECT_TRUE(IsHidden(scan, 8, {3, 0}));
  EXPECT_FALSE(IsHidden(scan, 8, {3, 1}));
  EXPECT_TRUE(IsHidden(scan, 8, {-3, 0}));
  EXPECT_TRUE(IsHidden(scan, 2, {0, 3}));
}

TEST(LegFinder, InAScanWithoutBeamsAllIsHidden) { EXPECT_TRUE(IsHidden({}, 8, {1, 0})); }

}  // namespace
}  // namespace coppice::robot::perception
