#include "robot_app/simulation/camera/person_relief.h"

#include <gtest/gtest.h>

namespace coppice::robot::simulation {
namespace {

constexpr double kLensHeight = 1.4;
const Lens kLens{600, 600, 320, 240};

// Stands 2 m before the lens and looks at it.
PersonRelief Person() {
  Stance stance;
  stance.position = {2, 0};
  stance.heading = kPi;
  return {MakeFigure(stance), kLens, {0, 0, 0}, kLensHeight};
}

// The row of a height at 2 m.
int RowOf(double height) {
  return static_cast<int>(kLens.cy + kLens.fy * (kLensHeight - height) / 2);
}

TEST(PersonRelief, TheChestIsNearerThanTheAxisAndTheHeadLessSo) {
  PersonRelief person = Person();
  person.LookAlong(320);
  EXPECT_NEAR(person.At(RowOf(1.2)), 1.83, 0.01);
  EXPECT_NEAR(person.At(RowOf(1.6)), 1.9, 0.01);
}

TEST(PersonRelief, TheBodyIsRound) {
  PersonRelief person = Person();
  person.LookAlong(320 + 40);
  const double side = person.At(RowOf(1.2));
  EXPECT_GT(side, 1.85);
  EXPECT_LT(side, 1.95);
}

TEST(PersonRelief, BesideThePillarsItIsTheAxis) {
  PersonRelief person = Person();
  person.LookAlong(320 + 110);
  EXPECT_DOUBLE_EQ(person.At(RowOf(1.2)), 2);
}

}  // namespace
}  // namespace coppice::robot::simulation
