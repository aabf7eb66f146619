#include "robot_app/simulation/lidar.h"

#include <gtest/gtest.h>

#include "tests/robot_app/simulation/test_floor.h"

namespace coppice::robot::simulation {
namespace {

const RayCaster kWall(Segments{{{5, -50}, {5, 50}}});

TEST(Lidar, LooksForwardInTheMiddleOfTheTurn) {
  Lidar lidar({}, 1);
  lidar.Measure(3, {1, 0, 0}, kWall, {});
  const Scan& scan = lidar.scan();
  ASSERT_EQ(scan.ranges.size(), 541U);
  EXPECT_EQ(scan.time, 3);
  EXPECT_NEAR(scan.angle_min + 270 * scan.angle_step, 0, 1e-12);
  EXPECT_NEAR(scan.ranges[270], 5 - 1.25, 0.05);
  EXPECT_TRUE(std::isinf(scan.ranges[0]));
}

TEST(Lidar, CountsAnglesCounterClockwise) {
  Lidar lidar({}, 1);
  lidar.Measure(0, {4.75, 0, -kPi / 2}, RayCaster(Segments{{{5, -50}, {5, 50}}}), {});
  EXPECT_NEAR(lidar.scan().ranges[450], 0.25, 0.05);  // 90 degrees to the left
  EXPECT_TRUE(std::isinf(lidar.scan().ranges[90]));
}

TEST(Lidar, SeesPeople) {
  Lidar lidar({}, 1);
  lidar.Measure(0, {0, 0, 0}, kWall, {{{2.25, 0}, 0.25}});
  EXPECT_NEAR(lidar.scan().ranges[270], 1.75, 0.05);
}

TEST(Lidar, NoiseHasTheGivenSpread) {
  LidarOptions options;
  options.beams = 20001;
  options.field_of_view = 1e-6;
  Lidar lidar(options, 5);
  lidar.Measure(0, {0, 0, 0}, kWall, {});
  double sum = 0;
  double square = 0;
  for (const float range : lidar.scan().ranges) {
    sum += range - 4.75;
    square += (range - 4.75) * (range - 4.75);
  }
  EXPECT_NEAR(sum / options.beams, 0, 0.0005);
  EXPECT_NEAR(std::sqrt(square / options.beams), 0.01, 0.0005);
}

TEST(Lidar, TheSameSeedGivesTheSameScan) {
  Lidar a({}, 9);
  Lidar b({}, 9);
  Lidar c({}, 10);
  for (Lidar* lidar : {&a, &b, &c}) lidar->Measure(0, {0, 0, 0}, kWall, {});
  EXPECT_EQ(a.scan().ranges, b.scan().ranges);
  EXPECT_NE(a.scan().ranges, c.scan().ranges);
}

}  // namespace
}  // namespace coppice::robot::simulation
