#include "robot_app/slam/clouds/cloud_descriptor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/robot_app/slam/clouds/room.h"

namespace coppice::robot::slam {
namespace {

TEST(CloudDescriptor, StaysTheSameWhenTheRobotTurns) {
  const CloudDescriptor straight = Describe(RoomFrom(0.3, 0.2, 0));
  const CloudDescriptor turned = Describe(RoomFrom(0.3, 0.2, 1.3));
  const CloudDescriptor other = Describe(RoomFrom(-2.5, 1.4, 0));
  float same = 0, elsewhere = 0;
  for (std::size_t i = 0; i < kScalars; ++i) {
    same += std::abs(straight.scalars[i] - turned.scalars[i]);
    elsewhere += std::abs(straight.scalars[i] - other.scalars[i]);
  }
  EXPECT_LT(4 * same, elsewhere);
}

TEST(CloudDescriptor, TheLikeliestTurnIsHowTheRobotHasTurned) {
  for (const double yaw : {0.5, 2.0, -2.8}) {
    const auto turns =
        LikelyTurns(Describe(RoomFrom(0, 0, 0)), Describe(RoomFrom(0.2, 0.1, yaw)), 2);
    ASSERT_EQ(turns.size(), 2U);
    EXPECT_NEAR(std::remainder(turns[0] - yaw, 2 * M_PI), 0, 0.1) << yaw;
  }
}

TEST(CloudDescriptor, APairIsTheSameIfItIsSwapped) {
  const CloudDescriptor a = Describe(RoomFrom(0, 0, 0)), b = Describe(RoomFrom(1, 1, 2));
  const PairFeatures forth = Compare(a, b), back = Compare(b, a);
  for (std::size_t i = 0; i < kPairFeatures; ++i) EXPECT_NEAR(forth[i], back[i], 1e-5) << i;
}

TEST(CloudDescriptor, OfNoPointsThereAreFiniteNumbers) {
  const CloudDescriptor nothing = Describe({});
  for (const float feature : Compare(nothing, Describe(RoomFrom(0, 0, 0)))) {
    EXPECT_TRUE(std::isfinite(feature));
  }
}

}  // namespace
}  // namespace coppice::robot::slam
