#include "robot_app/simulation/safety_field.h"

#include <gtest/gtest.h>

#include "tests/robot_app/simulation/test_floor.h"

namespace coppice::robot::simulation {
namespace {

constexpr Pose2 kMounting{0.25, 0, 0};
constexpr double kRadius = 0.33;

double Gap(const RayCaster& still, const std::vector<Disc>& moving = {}, const Pose2& base = {}) {
  return FrontGap(base, kMounting, kRadius, 1.0, still, moving);
}

TEST(SafetyField, MeasuresFromTheEdgeOfTheFootprint) {
  EXPECT_NEAR(Gap(RayCaster(Segments{{{0.5, -1}, {0.5, 1}}})), 0.17, 1e-9);
  EXPECT_NEAR(Gap(RayCaster(Segments{{{-1, 0.5}, {1, 0.5}}}), {}, {0, 0, kPi / 2}), 0.17, 1e-9);
}

TEST(SafetyField, IsFreeWhenNothingIsNear) {
  EXPECT_EQ(Gap(RayCaster()), 1.0);
  EXPECT_EQ(Gap(RayCaster(Segments{{{3, -1}, {3, 1}}})), 1.0);
}

TEST(SafetyField, DoesNotMindWallsBeside) {
  EXPECT_EQ(Gap(RayCaster(Segments{{{-5, 0.4}, {5, 0.4}}, {{-5, -0.4}, {5, -0.4}}})), 1.0);
}

TEST(SafetyField, SeesPeopleAndTheEdgeOfADoorFrame) {
  EXPECT_NEAR(Gap(RayCaster(), {{{1, 0}, 0.25}}), 0.42, 0.01);
  EXPECT_LT(Gap(RayCaster(Segments{{{0.5, 0.3}, {0.5, 3}}})), 0.4);
}

TEST(SafetyField, DoesNotLookBehind) {
  EXPECT_EQ(Gap(RayCaster(Segments{{{-0.4, -1}, {-0.4, 1}}})), 1.0);
}

}  // namespace
}  // namespace coppice::robot::simulation
