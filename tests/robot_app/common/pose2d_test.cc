#include "robot_app/common/pose2d.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot {
namespace {

TEST(Pose2D, NormalizedAnglesLieInOneTurn) {
  EXPECT_NEAR(NormalizeAngle(3 * M_PI), M_PI, 1e-12);
  EXPECT_NEAR(NormalizeAngle(-3 * M_PI), M_PI, 1e-12);
  EXPECT_NEAR(NormalizeAngle(7), 7 - 2 * M_PI, 1e-12);
}

TEST(Pose2D, RelativeToUndoesCompose) {
  const Pose2D frame{1, 2, 2.5};
  const Pose2D local{-3, 0.5, 1.5};
  const Pose2D back = RelativeTo(frame, Compose(frame, local));
  EXPECT_NEAR(back.x, local.x, 1e-12);
  EXPECT_NEAR(back.y, local.y, 1e-12);
  EXPECT_NEAR(back.yaw, local.yaw, 1e-12);
}

TEST(Pose2D, AHalfCircleEndsAtItsDiameter) {
  const Pose2D end = Advance({0, 0, 0}, {1, 1}, M_PI);
  EXPECT_NEAR(end.x, 0, 1e-12);
  EXPECT_NEAR(end.y, 2, 1e-12);
  EXPECT_NEAR(std::abs(end.yaw), M_PI, 1e-12);
}

TEST(Pose2D, DrivingStraightIsTheLimitOfAWideArc) {
  const Pose2D straight = Advance({0, 0, 0.5}, {2, 0}, 3);
  const Pose2D arc = Advance({0, 0, 0.5}, {2, 1e-8}, 3);
  EXPECT_NEAR(straight.x, arc.x, 1e-6);
  EXPECT_NEAR(straight.y, 6 * std::sin(0.5), 1e-12);
}

TEST(Pose2D, ChangesAreLimitedBothWays) {
  EXPECT_DOUBLE_EQ(LimitChange(0, 1, 0.5, 0.1), 0.05);
  EXPECT_DOUBLE_EQ(LimitChange(0, -1, 0.5, 0.1), -0.05);
  EXPECT_DOUBLE_EQ(LimitChange(0, 0.01, 0.5, 0.1), 0.01);
}

TEST(Pose2D, IsNotReadHalf) {
  for (const char* text : {"", "1 2", "1 2 3 4", "1 2 nan", "here"}) {
    EXPECT_FALSE(ParsePose(text)) << text;
  }
  EXPECT_TRUE(ParsePose(" 1 2 3 \n"));
}

TEST(Pose2D, APlaceIsTwoNumbersAndNothingElse) {
  for (const char* text : {"", "1", "1 2 3", "1 inf", "the lab"}) {
    EXPECT_FALSE(ParsePlace(text)) << text;
  }
  const auto place = ParsePlace("1 -2.5");
  ASSERT_TRUE(place);
  EXPECT_DOUBLE_EQ(place->y, -2.5);
}

}  // namespace
}  // namespace coppice::robot
