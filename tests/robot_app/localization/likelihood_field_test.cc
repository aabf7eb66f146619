#include "robot_app/localization/likelihood_field.h"

#include <gtest/gtest.h>

#include "tests/robot_app/navigation/test_floor.h"

namespace coppice::robot::localization {
namespace {

class LikelihoodFieldTest : public testing::Test {
 protected:
  // Walls of one cell; their middles lie at 0.025 and 4.975.
  const LikelihoodField field_{navigation::EmptyRoom(5, 5)};
};

TEST_F(LikelihoodFieldTest, TellsTheDistanceFromTheNearestWall) {
  EXPECT_FLOAT_EQ(field_.Distance(0.01, 2), 0);
  EXPECT_NEAR(field_.Distance(1, 2.5), 1, 0.03);
  EXPECT_NEAR(field_.Distance(2.5, 2.5), LikelihoodField::kReach, 0.01);
  EXPECT_FLOAT_EQ(field_.Distance(-9, 2), LikelihoodField::kReach);
  EXPECT_TRUE(field_.Free(1, 1));
  EXPECT_FALSE(field_.Free(0.01, 1));
  EXPECT_FALSE(field_.Free(-9, 1));
}

TEST_F(LikelihoodFieldTest, IsSmoothBetweenTheCells) {
  const auto slope = field_.DistanceAndSlope(0.5125, 2.5);
  EXPECT_NEAR(slope.distance, 0.5125 - 0.025, 1e-6);
  EXPECT_NEAR(slope.along_x, 1, 1e-6);
  EXPECT_NEAR(slope.along_y, 0, 1e-6);
  EXPECT_EQ(field_.DistanceAndSlope(-3, 0).along_x, 0);
}

TEST_F(LikelihoodFieldTest, ABeamEndsAtTheFirstWall) {
  EXPECT_NEAR(field_.Cast({1, 2.5}, {9, 2.5}), 3.95, 0.06);
  EXPECT_NEAR(field_.Cast({1, 1}, {-1, -1}), std::sqrt(2) * 0.95, 0.1);
  EXPECT_EQ(field_.Cast({1, 2.5}, {4, 2.5}), HUGE_VAL);
  EXPECT_EQ(field_.Cast({1, 2.5}, {1, 2.5}), HUGE_VAL);
}

}  // namespace
}  // namespace coppice::robot::localization
