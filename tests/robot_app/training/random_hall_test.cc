#include "robot_app/training/random_hall.h"

#include <gtest/gtest.h>

namespace coppice::robot::training {
namespace {

TEST(RandomHall, TheSameSeedBuildsTheSameHall) {
  std::mt19937_64 a(4), b(4);
  const Site first = MakeRandomHall(a), second = MakeRandomHall(b);
  ASSERT_EQ(first.still.panels.size(), second.still.panels.size());
  for (std::size_t i = 0; i < first.still.panels.size(); ++i) {
    EXPECT_EQ(first.still.panels[i].edge.a.x, second.still.panels[i].edge.a.x);
    EXPECT_EQ(first.still.panels[i].top, second.still.panels[i].top);
  }
}

TEST(RandomHall, AnotherSeedBuildsAnotherHall) {
  std::mt19937_64 a(4), b(5);
  EXPECT_NE(MakeRandomHall(a).area.size.x, MakeRandomHall(b).area.size.x);
}

TEST(RandomHall, NothingIsFreeInsideABoxOrBesideAWall) {
  Site site;
  site.area = {{0, 0}, {10, 10}, 0};
  site.still.AddBox({{0, 0}, {1, 1}, 0}, 1, simulation::Material::kFurniture);
  EXPECT_FALSE(IsFree(site, {0, 0}, 0.1));
  EXPECT_FALSE(IsFree(site, {0.6, 0}, 0.2));
  EXPECT_TRUE(IsFree(site, {0.8, 0}, 0.2));
  EXPECT_FALSE(IsFree(site, {6, 0}, 0.2));
}

}  // namespace
}  // namespace coppice::robot::training
