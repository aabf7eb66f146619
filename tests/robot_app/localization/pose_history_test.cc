#include "robot_app/localization/pose_history.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::localization {
namespace {

TEST(PoseHistory, InterpolatesAlsoAcrossTheHalfTurn) {
  PoseHistory history;
  history.Add(1, {0, 0, 3.1});
  history.Add(1.1, {0.2, 0.1, -3.1});
  const auto pose = history.At(1.05);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->x, 0.1, 1e-9);
  EXPECT_NEAR(std::abs(pose->yaw), M_PI, 1e-6);
  EXPECT_NEAR(history.At(1.1)->y, 0.1, 1e-9);
  EXPECT_FALSE(history.At(1.2));
  EXPECT_FALSE(history.At(0.9));
  EXPECT_FALSE(history.At(NAN));
}

TEST(PoseHistory, ForgetsWhatIsOld) {
  PoseHistory history(1);
  for (int i = 0; i < 100; ++i) history.Add(i * 0.1, {i * 0.1, 0, 0});
  EXPECT_FALSE(history.At(8));
  EXPECT_TRUE(history.At(9));
  EXPECT_EQ(history.frame(), 0);
}

TEST(PoseHistory, NoticesANewFrameByTheJump) {
  PoseHistory history;
  history.Add(1, {5, 5, 1});
  history.Add(1.05, {5.02, 5, 1});
  EXPECT_EQ(history.frame(), 0);
  history.Add(1.6, {0, 0, 0});
  EXPECT_EQ(history.frame(), 1);
  EXPECT_FALSE(history.At(1.5));
  EXPECT_TRUE(history.At(1.6));
}

TEST(PoseHistory, StartsAnewWhenTimeIsSetBackButNotForWhatWasOvertaken) {
  PoseHistory history;
  history.Add(100, {});
  history.Add(99.9, {1, 1, 1});
  EXPECT_EQ(history.newest(), 100);
  history.Add(10, {});
  EXPECT_EQ(history.newest(), 10);
  EXPECT_EQ(history.frame(), 1);
  history.Add(NAN, {});
  history.Add(10.1, {NAN, 0, 0});
  EXPECT_EQ(history.newest(), 10);
}

}  // namespace
}  // namespace coppice::robot::localization
