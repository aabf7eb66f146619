#include "robot_app/perception/clouds/features.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/robot_app/perception/clouds/painted_image.h"

namespace coppice::robot::perception {
namespace {

Features DescribeFirst(const RangeImage& image) {
  std::vector<Surface> surfaces;
  FindGround(image, {}, surfaces);
  Clusters clusters;
  ClusterByDepthSteps(image, surfaces, {}, clusters);
  return Describe(image, clusters[0]);
}

TEST(Describe, TellsTheExtentsAsSeen) {
  const Features features = DescribeFirst(PaintedCloud({{4, 0, 0.3, 1.6}}).image());
  EXPECT_NEAR(features[0], 3.78, 0.05);  // distance of the middle of the front
  EXPECT_NEAR(features[4], 1.5, 0.15);   // the highest ring below the top
  EXPECT_NEAR(features[6], 0.57, 0.05);  // across the view
}

TEST(Describe, IsTheSameFromAllSides) {
  const Features ahead = DescribeFirst(PaintedCloud({{4, 0, 0.3, 1.6}}).image());
  const Features left = DescribeFirst(PaintedCloud({{0, 4, 0.3, 1.6}}).image());
  for (std::size_t i = 0; i < ahead.size(); ++i) EXPECT_NEAR(ahead[i], left[i], 0.02) << i;
}

TEST(Describe, APillarIsRound) {
  EXPECT_GT(DescribeFirst(PaintedCloud({{4, 0, 0.3, 1.6}}).image())[11], 0.5F);
}

TEST(Describe, WhoIsHalfBehindAnotherHasAnEdgeThatIsNotTheOwn) {
  const PaintedCloud cloud({{4, 0, 0.3, 1.6}, {2, 0.15, 0.15, 1.6}});
  const RangeImage image = cloud.image();
  std::vector<Surface> surfaces;
  FindGround(image, {}, surfaces);
  Clusters clusters;
  ClusterByDepthSteps(image, surfaces, {}, clusters);
  ASSERT_EQ(clusters.size(), 2U);
  std::vector<float> hidden{Describe(image, clusters[0])[14], Describe(image, clusters[1])[14]};
  std::sort(hidden.begin(), hidden.end());
  EXPECT_EQ(hidden[0], 0);
  EXPECT_GT(hidden[1], 0.3F);
}

}  // namespace
}  // namespace coppice::robot::perception
