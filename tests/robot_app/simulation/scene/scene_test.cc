#include "robot_app/simulation/scene/scene.h"

#include <gtest/gtest.h>

#include <random>

namespace coppice::robot::simulation {
namespace {

constexpr double kFar = 100;

Hit Cast(const Scene& scene, const Vec3& origin, double yaw, double slope) {
  std::vector<Hit> hits;
  scene.CastFan(origin, Direction(yaw), {slope}, kFar, hits);
  return hits[0];
}

TEST(Scene, MeetsTheFloorAndTheCeiling) {
  StillScene still;
  still.ceiling = 2.5;
  const Scene scene(still);
  EXPECT_DOUBLE_EQ(Cast(scene, {0, 0, 1}, 0, -0.1).range, 10);
  EXPECT_DOUBLE_EQ(Cast(scene, {0, 0, 1}, 0, 0.1).range, 15);
  EXPECT_TRUE(std::isinf(Cast(scene, {0, 0, 1}, 0, 0).range));
}

TEST(Scene, SeesNothingInTheSky) {
  EXPECT_TRUE(std::isinf(Cast(Scene(), {0, 0, 1}, 0, 0.2).range));
}

TEST(Scene, LooksOverWhatIsLow) {
  StillScene still;
  still.panels.push_back({{{2, -5}, {2, 5}}, 0.5});
  still.panels.push_back({{{6, -5}, {6, 5}}, 2.5});
  const Scene scene(still);
  EXPECT_DOUBLE_EQ(Cast(scene, {0, 0, 1}, 0, 0).range, 6);
  EXPECT_DOUBLE_EQ(Cast(scene, {0, 0, 1}, 0, -0.4).range, 2);
}

TEST(Scene, SeesTheTopOfABoxFromAbove) {
  StillScene still;
  still.AddBox({{3, 0}, {2, 2}}, 0.75, Material::kFurniture);
  const Scene scene(still);
  EXPECT_NEAR(Cast(scene, {0, 0, 1.2}, 0, -0.18).range, 2.5, 1e-9);
}

TEST(Scene, TellsHowMuchWhatItMeetsFacesTheRay) {
  StillScene still;
  still.AddBox({{3, 0}, {2, 2}, kPi / 6}, 0.75, Material::kFurniture);
  const Scene scene(still);
  EXPECT_NEAR(Cast(scene, {-0.5, -2, 0.5}, kPi / 6, 0).facing, 1, 1e-9);
  EXPECT_NEAR(Cast(scene, {0, 0, 0.5}, 0, 0).facing, std::cos(kPi / 6), 1e-9);
  EXPECT_EQ(Cast(scene, {0, 0, 0.5}, 0, -0.4).facing, 0) << "the floor";
  EXPECT_EQ(Cast(scene, {0, 0, 1.2}, 0, -0.18).facing, 0) << "the roof";
}

TEST(Scene, ARoundThingFacesOnlyWhoLooksAtItsMiddle) {
  Scene scene;
  Figure post;
  post.bounds = {{2, 0}, 0.5};
  post.parts.fill({{{2, 0}, 0.5}, 0, 1});
  scene.SetFigures({post});
  EXPECT_NEAR(Cast(scene, {0, 0, 0.5}, 0, 0).facing, 1, 1e-9);
  EXPECT_NEAR(Cast(scene, {0, 0.3, 0.5}, 0, 0).facing, 0.8, 1e-9);
}

TEST(Scene, HitsFartherThanTheRangeInTheAirAreNone) {
  StillScene still;
  still.panels.push_back({{{99.9, -5}, {99.9, 5}}, 50});
  const Scene scene(still);
  EXPECT_DOUBLE_EQ(Cast(scene, {0, 0, 1}, 0, 0).range, 99.9);
  EXPECT_TRUE(std::isinf(Cast(scene, {0, 0, 1}, 0, 0.2).range));
}

// What is solid, point by point: the other way to find where a ray ends.
bool IsSolid(const StillScene& still, const std::vector<Figure>& figures, const Vec3& point) {
  if (point.z <= 0 || point.z >= still.ceiling) return true;
  for (const Roof& box : still.roofs) {
    if (point.z <= box.height && Distance(point.xy(), box.shape) <= 0) return true;
  }
  for (const Figure& figure : figures) {
    for (const Pillar& part : figure.parts) {
      const Vec2 from = point.xy() - part.disc.center;
      const double radius = part.disc.radius;
      const bool is_inside = from.x * from.x + from.y * from.y <= radius * radius;
      if (is_inside && point.z >= part.bottom && point.z <= part.top) return true;
    }
  }
  return false;
}

double March(const StillScene& still, const std::vector<Figure>& figures, const Vec3& origin,
             Vec2 direction, double slope) {
  constexpr double kStep = 0.002;
  double range = 0;
  while (range < 20) {
    const Vec2 at = origin.xy() + direction * range;
    if (IsSolid(still, figures, {at.x, at.y, origin.z + slope * range})) return range;
    range += kStep;
  }
  return range;
}

TEST(Scene, RaysEndWhereAWalkAlongThemMeetsSomethingSolid) {
  std::mt19937 random(3);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  StillScene still;
  still.ceiling = 2.5;
  std::vector<Figure> figures;
  for (int i = 0; i < 12; ++i) {
    const Vec2 at = Direction(uniform(-kPi, kPi)) * uniform(2.5, 8);
    still.AddBox({at, {uniform(0.3, 2), uniform(0.3, 2)}, uniform(-3, 3)}, uniform(0.3, 2.2),
                 Material::kFurniture);
    Stance stance;
    stance.position = Direction(uniform(-kPi, kPi)) * uniform(1, 8);
    stance.heading = uniform(-kPi, kPi);
    stance.walked = uniform(0, 2);
    stance.walks = true;
    stance.height = uniform(1.5, 2);
    figures.push_back(MakeFigure(stance));
  }
  Scene scene(still);
  scene.SetFigures(figures);
  int others = 0;
  constexpr int kRays = 3000;
  for (int i = 0; i < kRays; ++i) {
    const Vec3 origin{uniform(-0.3, 0.3), uniform(-0.3, 0.3), uniform(0.2, 1.6)};
    const Vec2 direction = Direction(uniform(-kPi, kPi));
    const double slope = uniform(-0.5, 0.5);
    std::vector<Hit> hits;
    scene.CastFan(origin, direction, {slope}, kFar, hits);
    const double marched = March(still, figures, origin, direction, slope);
    if (std::abs(std::min(hits[0].range, 20.0) - marched) > 0.003) ++others;
  }
  EXPECT_LE(others, 2);  // rays that graze an edge between two steps
}

TEST(Scene, AFanIsItsRaysOneByOne) {
  StillScene still;
  still.AddBox({{3, 0}, {1, 1}, 0.4}, 1.0, Material::kFurniture);
  still.panels.push_back({{{8, -5}, {8, 5}}, 1.5});
  const Scene scene(still);
  const std::vector<double> slopes{-0.25, -0.1, -0.02, 0, 0.02, 0.1, 0.25};
  std::vector<Hit> fan;
  scene.CastFan({0, 0, 1.2}, Direction(0.05), slopes, kFar, fan);
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    EXPECT_EQ(fan[i].range, Cast(scene, {0, 0, 1.2}, 0.05, slopes[i]).range) << slopes[i];
  }
}

}  // namespace
}  // namespace coppice::robot::simulation
