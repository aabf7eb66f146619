#include "robot_app/simulation/lidar_3d.h"

#include <gtest/gtest.h>

#include "robot_app/simulation/world.h"
#include "tests/robot_app/simulation/test_floor.h"

namespace coppice::robot::simulation {
namespace {

Scene WallAhead() {
  StillScene still;
  still.panels.push_back({{{5, -50}, {5, 50}}, 10});
  return Scene(still);
}

CloudPoint At(const Cloud& cloud, int column, int ring) {
  return cloud.points[static_cast<std::size_t>(column) * 16 + static_cast<std::size_t>(ring)];
}

Cloud OneTurn(const Lidar3dOptions& options, std::uint64_t seed, const Scene& scene) {
  Lidar3d lidar(options, seed);
  lidar.Turn(2, options.period, {}, scene);
  return lidar.cloud();
}

TEST(Lidar3d, ATurnHasAllColumnsOfAllRings) {
  EXPECT_EQ(OneTurn({}, 1, WallAhead()).points.size(), 16U * 900U);
}

TEST(Lidar3d, TheCloudComesWithTheLastColumnOfATurn) {
  Lidar3d lidar({}, 1);
  const Scene scene = WallAhead();
  for (int i = 0; i < 4; ++i) lidar.Turn(2 + 0.02 * i, 0.02, {}, scene);
  EXPECT_TRUE(lidar.cloud().points.empty());
  lidar.Turn(2.08, 0.02, {}, scene);
  EXPECT_EQ(lidar.cloud().points.size(), 16U * 900U);
  EXPECT_NEAR(lidar.cloud().time, 2, 1e-9);
}

TEST(Lidar3d, LooksForwardInTheMiddleOfATurn) {
  const CloudPoint point = At(OneTurn({}, 1, WallAhead()), 450, 8);
  EXPECT_NEAR(point.x, 5, 0.15);
  EXPECT_NEAR(point.y, 0, 0.01);
  EXPECT_NEAR(point.z, 5 * std::tan(kPi / 180), 0.01);
  EXPECT_EQ(point.ring, 8);
  EXPECT_NEAR(point.time, 0.05, 1e-6);
  EXPECT_EQ(point.intensity, 70);
}

TEST(Lidar3d, TurnsClockwise) {
  const Cloud cloud = OneTurn({}, 1, WallAhead());
  EXPECT_GT(At(cloud, 420, 8).y, 0);
  EXPECT_LT(At(cloud, 480, 8).y, 0);
}

TEST(Lidar3d, WhatMeetsNothingIsNotANumber) {
  EXPECT_TRUE(std::isnan(At(OneTurn({}, 1, WallAhead()), 0, 15).x));
}

TEST(Lidar3d, RingsAreTwoDegreesApart) {
  const Cloud cloud = OneTurn({}, 1, WallAhead());
  for (int ring = 0; ring < 16; ++ring) {
    const CloudPoint point = At(cloud, 450, ring);
    if (std::isnan(point.x)) continue;
    EXPECT_NEAR(std::atan2(point.z, std::hypot(point.x, point.y)), (2 * ring - 15) * kPi / 180,
                1e-6);
  }
}

TEST(Lidar3d, NoiseHasTheGivenSpread) {
  Lidar3dOptions options;
  options.columns = 90000;
  const Cloud cloud = OneTurn(options, 4, WallAhead());
  double square = 0;
  int count = 0;
  for (int column = 44000; column < 46000; ++column) {
    const CloudPoint point = At(cloud, column, 7);
    const double angle = kPi - 2 * kPi * column / options.columns;
    const double range = std::hypot(point.x, point.y, point.z);
    const double truth = 5 / std::cos(angle) / std::cos(kPi / 180);
    square += (range - truth) * (range - truth);
    ++count;
  }
  EXPECT_NEAR(std::sqrt(square / count), 0.03, 0.002);
}

std::vector<float> RangesOf(World& world) {
  world.SetLidar3dOn(true);
  for (int i = 0; i < 50; ++i) world.Step(0.02, Velocity{0.5, 0.1});
  std::vector<float> ranges;
  for (const CloudPoint& point : world.lidar_3d().cloud().points) {
    if (!std::isnan(point.x)) ranges.push_back(point.x);
  }
  return ranges;
}

TEST(Lidar3d, TheSameSeedGivesTheSameClouds) {
  WorldOptions options;
  options.start = Pose2{20, 0, 0};
  World a(LoadInstitute(), options);
  World b(LoadInstitute(), options);
  options.seed = 2;
  World c(LoadInstitute(), options);
  const std::vector<float> ranges = RangesOf(a);
  EXPECT_GT(ranges.size(), 10000U);
  EXPECT_EQ(ranges, RangesOf(b));
  EXPECT_NE(ranges, RangesOf(c));
}

TEST(Lidar3d, ItsNoiseChangesNoOtherSensor) {
  WorldOptions options;
  options.start = Pose2{20, 0, 0};
  World with(LoadInstitute(), options);
  World without(LoadInstitute(), options);
  with.SetLidar3dOn(true);
  for (int i = 0; i < 50; ++i) {
    with.Step(0.02, Velocity{0.5, 0.1});
    without.Step(0.02, Velocity{0.5, 0.1});
  }
  EXPECT_EQ(with.scan().ranges, without.scan().ranges);
  EXPECT_EQ(with.odometry().pose().x, without.odometry().pose().x);
}

TEST(Lidar3d, SeesAPersonFromTheFeetToTheHead) {
  Floor room = MakeRoom();
  room.people.push_back({"anna", 1, {{4, 0}, {4.001, 0}}, 1.7});
  WorldOptions options;
  options.start = Pose2{1.5, 0, 0};
  World world(room, options);
  world.SetLidar3dOn(true);
  for (int i = 0; i < 5; ++i) world.Step(0.02);
  double lowest = 9;
  double highest = 0;
  for (const CloudPoint& point : world.lidar_3d().cloud().points) {
    const bool is_person = std::abs(point.x - 2.5) < 0.3 && std::abs(point.y) < 0.3;
    const double z = point.z + world.lidar_3d().options().height;
    if (!is_person || z < 0.1) continue;
    lowest = std::min(lowest, z);
    highest = std::max(highest, z);
  }
  EXPECT_LT(lowest, 0.7);
  EXPECT_GT(highest, 1.55);
  EXPECT_LE(highest, 1.71);
}

}  // namespace
}  // namespace coppice::robot::simulation
