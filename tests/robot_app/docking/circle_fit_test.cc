#include "robot_app/docking/circle_fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::docking {
namespace {

// What a scanner at the origin sees of a disc 2 m ahead; every second beam is `noise` too long,
// every other too short.
std::vector<Point2D> Disc(double radius, double noise) {
  std::vector<Point2D> echoes;
  const double half = 0.8 * std::asin(radius / 2);
  for (int i = 0; i < 20; ++i) {
    const double angle = half * (i - 9.5) / 9.5;
    const double along = 2 * std::cos(angle);
    const double range =
        along - std::sqrt(along * along - 4 + radius * radius) + (i % 2 == 0 ? noise : -noise);
    echoes.push_back({range * std::cos(angle), range * std::sin(angle)});
  }
  return echoes;
}

TEST(CircleFit, FindsACircleOfAnySize) {
  for (const double radius : {0.05, 0.1, 0.25, 0.35, 0.6}) {
    EXPECT_LT(DeviationFromCircle(Disc(radius, 0)), 1e-4) << radius;
  }
}

TEST(CircleFit, TheDeviationIsTheNoise) {
  EXPECT_NEAR(DeviationFromCircle(Disc(0.3, 0.01)), 0.01, 0.001);
}

TEST(CircleFit, TwoLegsOfALandmarkAreNone) {
  std::vector<Point2D> echoes;
  for (int i = -15; i <= 15; ++i) {
    echoes.push_back({2 + std::abs(i) * 0.006, i * 0.0225});
  }
  EXPECT_GT(DeviationFromCircle(echoes), 0.005);
}

TEST(CircleFit, TooFewEchoesAreNone) {
  EXPECT_GT(DeviationFromCircle({}), 1);
  EXPECT_GT(DeviationFromCircle({{1, 0}, {1, 0.1}}), 1);
}

}  // namespace
}  // namespace coppice::robot::docking
