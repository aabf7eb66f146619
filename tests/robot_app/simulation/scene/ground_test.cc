#include "robot_app/simulation/scene/ground.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::simulation {
namespace {

const double kThreeDegrees = std::tan(3 * kPi / 180);
const Ground kHill({{0, 0}, {15, 15 * kThreeDegrees}});

TEST(Ground, IsStraightBetweenThePointsAndLevelBeyondThem) {
  EXPECT_DOUBLE_EQ(kHill.Height(-5), 0);
  EXPECT_NEAR(kHill.Height(7.5), 7.5 * kThreeDegrees, 1e-12);
  EXPECT_NEAR(kHill.Height(100), 15 * kThreeDegrees, 1e-12);
  EXPECT_DOUBLE_EQ(kHill.Slope(-5), 0);
  EXPECT_NEAR(kHill.Slope(3), kThreeDegrees, 1e-12);
  EXPECT_DOUBLE_EQ(kHill.Slope(20), 0);
}

TEST(Ground, ALevelBeamMeetsTheSlopeBeforeIt) {
  EXPECT_NEAR(kHill.Cast({-2, 0}, {1, 0}, 0.3, 20), 2 + 0.3 / kThreeDegrees, 1e-9);
}

TEST(Ground, ABeamIsLevelWithTheSlopeOnWhichTheRobotStands) {
  EXPECT_EQ(kHill.Cast({3, 0}, {1, 0}, 0.3, 20), 20);
}

TEST(Ground, GoingDownABeamMeetsTheFootWhereItBecomesLevel) {
  EXPECT_NEAR(kHill.Cast({3, 0}, {-1, 0}, 0.3, 20), 3 + 0.3 / kThreeDegrees, 1e-9);
}

TEST(Ground, AlongTheSlopeAndAwayFromItItIsNotMet) {
  EXPECT_EQ(kHill.Cast({3, 0}, {0, 1}, 0.3, 20), 20);
  EXPECT_EQ(kHill.Cast({-2, 0}, {-1, 0}, 0.3, 20), 20);
  EXPECT_EQ(Ground().Cast({3, 0}, {1, 0}, 0.3, 20), 20);
}

TEST(Ground, MetIsWhereTheBeamIsAsHighAsTheGround) {
  const Ground ground({{-20, 0}, {-5, 0.1}, {0, 0.5}, {4, 0.6}, {12, 1.4}, {30, 0.2}});
  for (double x = -30; x < 40; x += 0.7) {
    for (double angle = -3; angle < 3; angle += 0.3) {
      const Vec2 way = Direction(angle);
      const double range = ground.Cast({x, 0}, way, 0.3, 25);
      const auto gap = [&](double r) {
        return ground.Height(x) + 0.3 + ground.Slope(x) * way.x * r - ground.Height(x + way.x * r);
      };
      for (double r = 0; r < range - 0.05; r += 0.05) ASSERT_GT(gap(r), -1e-9) << x << " " << angle;
      if (range < 25) {
        ASSERT_NEAR(gap(range), 0, 1e-9) << x << " " << angle;
      }
    }
  }
}

}  // namespace
}  // namespace coppice::robot::simulation
