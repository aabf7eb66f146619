#include "robot_app/expression/limbs.h"

#include <gtest/gtest.h>

#include "tests/support/folders.h"

namespace coppice::robot::expression {
namespace {

TEST(Limbs, TurnNoFasterThanTheirJointsAndNotBeyondTheirLimits) {
  const auto robot = RobotDescription::Load(SourceFolder() + "/robot_app/description/sobi.urdf");
  Limbs limbs = Limbs::Of(robot.value()).value();
  const LimbAngles targets{1, -9, -9, 0};
  limbs.Move(targets, 0.1);
  const auto& joints = limbs.joints();
  EXPECT_DOUBLE_EQ(limbs.angles()[0], 0.1 * joints[0].velocity);
  EXPECT_DOUBLE_EQ(limbs.angles()[2], -0.1 * joints[2].velocity);
  for (int i = 0; i < 100; ++i) limbs.Move(targets, 0.1);
  EXPECT_DOUBLE_EQ(limbs.angles()[0], 1);
  EXPECT_DOUBLE_EQ(limbs.angles()[1], joints[1].lower);
}

}  // namespace
}  // namespace coppice::robot::expression
