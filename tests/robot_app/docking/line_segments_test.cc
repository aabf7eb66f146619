#include "robot_app/docking/line_segments.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace coppice::robot::docking {
namespace {

// In the middle of a square room whose walls are 1.5 m away.
LaserScan InARoom(std::size_t beams) {
  LaserScan scan;
  scan.mount = {};
  scan.angle_min = -M_PI / 4;
  scan.angle_increment = 2 * M_PI / static_cast<double>(beams);
  for (std::size_t i = 0; i < beams; ++i) {
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const double nearest = std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
    scan.ranges.push_back(static_cast<float>(1.5 / nearest));
  }
  return scan;
}

TEST(LineSegments, OfTheFinestScannerAreThoseOfAnyOtherAndAsSoonThere) {
  EXPECT_EQ(FindSegments(InARoom(720), 0.01, 3).size(), 4U);
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_EQ(FindSegments(InARoom(kMostBeams), 0.01, 3).size(), 4U);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(5));
}

}  // namespace
}  // namespace coppice::robot::docking
