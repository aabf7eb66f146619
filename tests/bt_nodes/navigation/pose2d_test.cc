#include "bt_nodes/navigation/pose2d.h"

#include <gtest/gtest.h>

namespace coppice::leaves {
namespace {

TEST(Pose2D, ReadsBackWhatItPrints) {
  Pose2D pose;
  ASSERT_TRUE(ValueTraits<Pose2D>::Parse(ValueTraits<Pose2D>::Print({1.5, -2.25, 3.125}), pose));
  EXPECT_EQ(pose.x, 1.5);
  EXPECT_EQ(pose.y, -2.25);
  EXPECT_EQ(pose.yaw, 3.125);
}

TEST(Pose2D, NeedsExactlyThreeFiniteNumbers) {
  Pose2D pose;
  for (const char* text : {"", "1;2", "1;2;3;4", "1;2;x", "1;nan;3", "1;2;inf", ";;"}) {
    EXPECT_FALSE(ValueTraits<Pose2D>::Parse(text, pose)) << text;
  }
}

}  // namespace
}  // namespace coppice::leaves
