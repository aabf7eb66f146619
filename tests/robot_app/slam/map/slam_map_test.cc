#include "robot_app/slam/map/slam_map.h"

#include <gmock/gmock.h>

#include <limits>

namespace coppice::robot::slam {
namespace {

using Eigen::Vector3f;
using testing::ElementsAre;

TEST(Thinned, TheFirstPointOfEachCubeRemainsInWholeCentimetres) {
  const CloudPoints points = {{1.032F, 0.5F, 0.2F}, {-0.01F, 0.5F, 0.2F}, {1.071F, 0.51F, 0.21F}};
  EXPECT_THAT(Thinned(points, 0.1F, 40),
              ElementsAre(Vector3f(-0.01F, 0.5F, 0.2F), Vector3f(1.03F, 0.5F, 0.2F)));
}

TEST(Thinned, CubesFollowEachOtherByXThenYThenZ) {
  const CloudPoints points = {{2, 1, 1}, {1, 2, -1}, {1, 2, -2}, {1, -1, 3}};
  EXPECT_THAT(Thinned(points, 0.5F, 40), ElementsAre(Vector3f(1, -1, 3), Vector3f(1, 2, -2),
                                                     Vector3f(1, 2, -1), Vector3f(2, 1, 1)));
}

TEST(Thinned, WhatIsFartherAwayInAnyDirectionOrNoPlaceAtAllIsLeftOut) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  constexpr float kEndless = std::numeric_limits<float>::infinity();
  const CloudPoints points = {{41, 0, 0},    {0, 0, -1e30F},   {kNone, 0, 0},
                              {0, 0, kNone}, {0, 0, kEndless}, {3, 0, 0}};
  EXPECT_THAT(Thinned(points, 0.05F, 40), ElementsAre(Vector3f(3, 0, 0)));
}

}  // namespace
}  // namespace coppice::robot::slam
