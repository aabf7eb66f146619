#include "robot_app/training/moving_crowd.h"

#include <gtest/gtest.h>

namespace coppice::robot::training {
namespace {

Site Square() {
  Site site;
  site.area = {{0, 0}, {10, 10}, 0};
  site.still.AddBox({{2, 2}, {1, 1}, 0}, 1, simulation::Material::kFurniture);
  return site;
}

TEST(MovingCrowd, NobodyTouchesAnybodyOrAnything) {
  const Site site = Square();
  MovingCrowd crowd(site, 8, {0, 0}, 0.8, 3);
  for (int i = 0; i < 2000; ++i) {
    crowd.Step(0.02);
    const auto& people = crowd.people();
    for (std::size_t a = 0; a < people.size(); ++a) {
      ASSERT_TRUE(IsFree(site, people[a].position, 0.25));
      ASSERT_GE(simulation::Length(people[a].position), 0.79);
      for (std::size_t b = 0; b < a; ++b) {
        ASSERT_GT(simulation::Length(people[a].position - people[b].position), 0.5);
      }
    }
  }
}

TEST(MovingCrowd, NobodyIsFasterThanLegsAre) {
  const Site site = Square();
  MovingCrowd crowd(site, 8, {0, 0}, 0.8, 4);
  for (int i = 0; i < 1000; ++i) {
    const auto before = crowd.people();
    crowd.Step(0.02);
    for (std::size_t a = 0; a < before.size(); ++a) {
      EXPECT_LE(simulation::Length(crowd.people()[a].position - before[a].position), 1.5 * 0.02);
    }
  }
}

TEST(MovingCrowd, EverybodyGetsAbout) {
  const Site site = Square();
  MovingCrowd crowd(site, 6, {0, 0}, 0.8, 5);
  for (int i = 0; i < 3000; ++i) crowd.Step(0.02);
  for (const auto& person : crowd.people()) EXPECT_GT(person.walked, 5);
}

TEST(MovingCrowd, TheSameSeedWalksTheSameWay) {
  const Site site = Square();
  MovingCrowd a(site, 6, {0, 0}, 0.8, 5), b(site, 6, {0, 0}, 0.8, 5);
  for (int i = 0; i < 500; ++i) {
    a.Step(0.02);
    b.Step(0.02);
  }
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(a.people()[i].position.x, b.people()[i].position.x);
  }
}

}  // namespace
}  // namespace coppice::robot::training
