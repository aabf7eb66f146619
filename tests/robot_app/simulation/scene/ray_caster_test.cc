#include "robot_app/simulation/scene/ray_caster.h"

#include <gtest/gtest.h>

#include <random>

#include "robot_app/simulation/world.h"
#include "tests/robot_app/simulation/test_floor.h"

namespace coppice::robot::simulation {
namespace {

double BruteForce(const std::vector<Segment>& segments, Vec2 origin, Vec2 direction, double range) {
  for (const Segment& s : segments) range = CastAtSegment(s, origin, direction, range);
  return range;
}

void CompareOnRandomRays(const std::vector<Segment>& segments, double cell, int count) {
  const RayCaster caster(segments, cell);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> x(-8, 58);
  std::uniform_real_distribution<double> y(-9, 9);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  for (int i = 0; i < count; ++i) {
    const Vec2 origin{x(random), y(random)};
    const Vec2 direction = Direction(angle(random));
    ASSERT_DOUBLE_EQ(caster.Cast(origin, direction, 20),
                     BruteForce(segments, origin, direction, 20))
        << origin.x << " " << origin.y << " towards " << direction.x << " " << direction.y;
  }
}

TEST(RayCaster, AgreesWithBruteForceInTheInstitute) {
  CompareOnRandomRays(EdgesOf(World(LoadInstitute()).still()), 0.5, 50000);
}

TEST(RayCaster, AgreesWithBruteForceAmongRandomSegmentsAndCells) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> x(0, 50);
  std::uniform_real_distribution<double> y(-6, 6);
  std::vector<Segment> segments;
  for (int i = 0; i < 200; ++i)
    segments.push_back({{x(random), y(random)}, {x(random), y(random)}});
  for (const double cell : {0.3, 1.0, 7.0}) CompareOnRandomRays(segments, cell, 2000);
}

TEST(RayCaster, MeetsAWallAlongTheAxes) {
  const RayCaster caster(Segments{{{2, -1}, {2, 1}}, {{-1, 3}, {1, 3}}});
  EXPECT_DOUBLE_EQ(caster.Cast({0, 0}, {1, 0}, 20), 2);
  EXPECT_DOUBLE_EQ(caster.Cast({0, 0}, {0, 1}, 20), 3);
  EXPECT_DOUBLE_EQ(caster.Cast({0, 0}, {-1, 0}, 20), 20);
  EXPECT_DOUBLE_EQ(caster.Cast({0, 0}, {1, 0}, 1.5), 1.5);
  EXPECT_DOUBLE_EQ(caster.Cast({-90, 0}, {1, 0}, 100), 92);
}

TEST(RayCaster, WithoutSegmentsSeesNothing) {
  EXPECT_DOUBLE_EQ(RayCaster().Cast({0, 0}, {1, 0}, 20), 20);
}

TEST(RayCaster, SeesADiscFromOutside) {
  const Disc disc{{5, 0.3}, 0.5};
  EXPECT_NEAR(CastAtDisc(disc, {0, 0}, {1, 0}, 20), 4.6, 1e-12);
  EXPECT_DOUBLE_EQ(CastAtDisc(disc, {0, 0}, {-1, 0}, 20), 20);
  EXPECT_DOUBLE_EQ(CastAtDisc(disc, {0, 1}, {1, 0}, 20), 20);
  EXPECT_DOUBLE_EQ(CastAtDisc(disc, {0, 0}, {1, 0}, 3), 3);
  EXPECT_DOUBLE_EQ(CastAtDisc(disc, {5, 0}, {1, 0}, 20), 0);
}

}  // namespace
}  // namespace coppice::robot::simulation
