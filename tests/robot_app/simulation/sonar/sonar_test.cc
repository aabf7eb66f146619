#include "robot_app/simulation/sonar/sonar.h"

#include <gtest/gtest.h>

#include "robot_app/simulation/world.h"
#include "tests/robot_app/simulation/test_floor.h"

namespace coppice::robot::simulation {
namespace {

SonarOptions WithoutNoise() {
  SonarOptions options;
  options.noise = 0;
  options.mounting = {};
  return options;
}

float RangeTo(const StillScene& still, const Pose2& base = {}) {
  return Sonar(WithoutNoise(), 1).Measure(base, Scene(still));
}

// A wall that the sonar at the origin looks at from `distance`; its normal is turned by `angle`.
StillScene Wall(double distance, double angle, double height = 2.5) {
  StillScene still;
  const Vec2 foot{distance, 0};
  const Vec2 half = Rotated({0, 20}, angle);
  still.panels.push_back({{foot - half, foot + half}, height});
  return still;
}

TEST(Sonar, HearsAWallAhead) { EXPECT_FLOAT_EQ(RangeTo(Wall(2, 0)), 2); }

TEST(Sonar, TellsTheDistanceOfTheNearestPointInItsCone) {
  // The foot of the perpendicular lies in the cone of 15 degrees to either side.
  EXPECT_NEAR(RangeTo(Wall(2, 10 * kPi / 180)), 2 * std::cos(10 * kPi / 180), 0.005);
}

TEST(Sonar, AWallThatItMeetsAtASlantIsNotHeard) {
  EXPECT_TRUE(std::isfinite(RangeTo(Wall(2, 50 * kPi / 180))));  // the side of the cone: 35
  EXPECT_EQ(RangeTo(Wall(2, 65 * kPi / 180)), std::numeric_limits<float>::infinity());
}

TEST(Sonar, TheFloorAndTheCeilingAreNotHeard) {
  StillScene empty;
  empty.ceiling = 0.4;
  EXPECT_EQ(RangeTo(empty), std::numeric_limits<float>::infinity());
}

TEST(Sonar, WhatIsBesideTheConeIsNotHeard) {
  StillScene still;
  still.AddBox({{1.5, 0.7}, {0.4, 0.4}, 0}, 1, Material::kCardboard);
  EXPECT_EQ(RangeTo(still), std::numeric_limits<float>::infinity());
  EXPECT_NEAR(RangeTo(still, {0, 0, 0.4}), 1.35, 0.1);
}

TEST(Sonar, NothingWithinItsRangeIsInfinity) {
  EXPECT_EQ(RangeTo(Wall(4.1, 0)), std::numeric_limits<float>::infinity());
}

TEST(Sonar, WhatIsTooNearIsMinusInfinity) {
  EXPECT_EQ(RangeTo(Wall(0.15, 0)), -std::numeric_limits<float>::infinity());
}

TEST(Sonar, HearsABoxThatIsNoHigherThanADoorstep) {
  StillScene still;
  still.AddBox({{1.2, 0}, {0.4, 0.4}, 0}, 0.06, Material::kCardboard);
  EXPECT_NEAR(RangeTo(still), 1.02, 0.02);
}

TEST(Sonar, HearsOverNothingThatStandsBeforeTheWall) {
  StillScene still = Wall(3, 0);
  still.AddBox({{1.5, 0}, {0.3, 0.3}, 0}, 0.15, Material::kCardboard);
  EXPECT_NEAR(RangeTo(still), 1.35, 0.02);
}

TEST(Sonar, HearsTheLegsOfAPerson) {
  Scene scene;
  scene.SetFigures(MakeFigures({{{2, 0}, 0, 0, false, 1.75, 0.4}}));
  EXPECT_NEAR(Sonar(WithoutNoise(), 1).Measure({}, scene), 1.93, 0.03);
}

TEST(Sonar, NoiseHasTheGivenSpread) {
  SonarOptions options = WithoutNoise();
  options.noise = 0.02;
  Sonar sonar(options, 3);
  const Scene scene(Wall(2, 0));
  double square = 0;
  for (int i = 0; i < 5000; ++i) square += std::pow(sonar.Measure({}, scene) - 2, 2);
  EXPECT_NEAR(std::sqrt(square / 5000), 0.02, 0.001);
}

// What a world with sonars has measured within a second at the end of the room.
std::vector<float> RangesOf(const Floor& floor, std::uint64_t seed) {
  WorldOptions options;
  options.start = Pose2{17, 0, 0};
  options.seed = seed;
  World world(floor, options);
  world.SetSonarsOn(true);
  std::vector<float> ranges;
  double time = -1;
  for (int i = 0; i < 50; ++i) {
    world.Step(0.02);
    if (world.echoes().time == time) continue;
    time = world.echoes().time;
    ranges.insert(ranges.end(), world.echoes().ranges.begin(), world.echoes().ranges.end());
  }
  return ranges;
}

TEST(Sonars, MeasureTenTimesASecondAllThree) { EXPECT_EQ(RangesOf(MakeRoom(), 1).size(), 30U); }

TEST(Sonars, TheSameSeedGivesTheSameRanges) {
  EXPECT_EQ(RangesOf(MakeRoom(), 1), RangesOf(MakeRoom(), 1));
  EXPECT_NE(RangesOf(MakeRoom(), 1), RangesOf(MakeRoom(), 2));
}

TEST(Sonars, LookForwardAndToEitherSide) {
  Floor room = MakeRoom();
  room.furniture = {{"left", {{18.3, 1.0}, {0.3, 0.3}, kPi / 6}, 1}};
  const std::vector<float> ranges = RangesOf(room, 1);
  EXPECT_NEAR(ranges[0], 1.17, 0.15);
  EXPECT_NEAR(ranges[1], 2.67, 0.1);
  EXPECT_GT(ranges[2], 2.67);
}

TEST(Sonars, AreSilentUntilTheyAreOn) {
  World world(MakeRoom());
  for (int i = 0; i < 50; ++i) world.Step(0.02);
  EXPECT_LT(world.echoes().time, 0);
}

TEST(Sonars, HearGlassThatTheLaserLooksThrough) {
  Floor room = MakeRoom();
  room.glass = {{{18.5, -2}, {18.5, 2}}};
  WorldOptions options;
  options.start = Pose2{17, 0, 0};
  World world(room, options);
  world.SetSonarsOn(true);
  world.Step(0.1);
  world.Step(0.1);
  EXPECT_NEAR(world.echoes().ranges[1], 1.5 - 0.33, 0.1);
  EXPECT_NEAR(world.scan().ranges[270], 3 - 0.25, 0.1);
}

TEST(Sonars, HearALowBoxThatTheLaserLooksOver) {
  Floor room = MakeRoom();
  room.furniture = {{"step", {{18.5, 0}, {0.4, 0.4}, 0}, 0.15}};
  WorldOptions options;
  options.start = Pose2{17, 0, 0};
  World world(room, options);
  world.SetSonarsOn(true);
  world.Step(0.1);
  world.Step(0.1);
  EXPECT_NEAR(world.echoes().ranges[1], 1.3 - 0.33, 0.1);
  EXPECT_NEAR(world.scan().ranges[270], 3 - 0.25, 0.1);
}

TEST(Sonars, TheirNoiseChangesNoOtherSensor) {
  WorldOptions options;
  options.start = Pose2{20, 0, 0};
  World with(LoadInstitute(), options);
  World without(LoadInstitute(), options);
  with.SetSonarsOn(true);
  for (int i = 0; i < 50; ++i) {
    with.Step(0.02, Velocity{0.5, 0.1});
    without.Step(0.02, Velocity{0.5, 0.1});
  }
  EXPECT_EQ(with.scan().ranges, without.scan().ranges);
  EXPECT_EQ(with.odometry().pose().x, without.odometry().pose().x);
}

}  // namespace
}  // namespace coppice::robot::simulation
