#include "robot_app/slam/clouds/registration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/robot_app/slam/clouds/room.h"

namespace coppice::robot::slam {
namespace {

Pose3 At(double x, double y, double yaw) {
  Pose3 pose = Pose3::Identity();
  pose.translation() << x, y, 0;
  pose.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

TEST(Registration, ATurnIsLaidUponAnotherToACentimetre) {
  const ThinCloud known = ThinOut(RoomFrom(0, 0, 0.2)), seen = ThinOut(RoomFrom(0.7, -0.3, 1.2, 2));
  const Pose3 truth = At(0, 0, 0.2).inverse() * At(0.7, -0.3, 1.2);
  const auto found = Register(known, seen, At(0.2, 0, 0.85));
  ASSERT_TRUE(found);
  EXPECT_TRUE(IsSure(*found)) << found->overlap << ' ' << found->residual << ' ' << found->hold;
  const Pose3 off = truth.inverse() * found->relative;
  EXPECT_LT(off.translation().norm(), 0.04);
  EXPECT_LT(Eigen::AngleAxisd(off.linear()).angle(), 0.01);
}

TEST(Registration, AWrongTurnIsNotSure) {
  const auto found =
      Register(ThinOut(RoomFrom(0, 0, 0)), ThinOut(RoomFrom(0.5, 0, 0, 2)), At(0, 0, M_PI));
  EXPECT_FALSE(found && IsSure(*found));
}

TEST(Registration, AlongABareCorridorNothingIsSure) {
  const auto found =
      Register(ThinOut(CorridorFrom(0, 0, 0)), ThinOut(CorridorFrom(0.8, 0, 0, 2)), At(0, 0, 0));
  ASSERT_TRUE(found);
  EXPECT_GT(found->overlap, 0.8);  // it fits,
  EXPECT_FALSE(IsSure(*found));    // as it does anywhere
}

TEST(Registration, AnotherRoomIsNotSure) {
  const auto found =
      Register(ThinOut(RoomFrom(0, 0, 0)),
               ThinOut(TurnIn(Walls({{-3, -3}, {4, -3}, {4, 3}, {-3, 3}, {-3, -3}}), {0, 0, 0}, 2)),
               At(0, 0, 0));
  EXPECT_FALSE(found && IsSure(*found));
}

TEST(Registration, OfNoPointsThereIsNone) {
  EXPECT_FALSE(Register(ThinOut({}), ThinOut(RoomFrom(0, 0, 0)), At(0, 0, 0)));
}

}  // namespace
}  // namespace coppice::robot::slam
