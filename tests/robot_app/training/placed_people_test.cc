#include "robot_app/training/placed_people.h"

#include <gtest/gtest.h>

namespace coppice::robot::training {
namespace {

TEST(PlacedPeople, NobodyStandsInAWallOrInTheRobotOrInSomebody) {
  std::mt19937_64 random(5);
  std::size_t most = 0;
  for (int i = 0; i < 30; ++i) {
    const Site site = MakeRandomHall(random);
    const PlacedPeople placed = PlacePeople(site, random);
    most = std::max(most, placed.people.size());
    for (std::size_t a = 0; a < placed.people.size(); ++a) {
      const simulation::Vec2 at = placed.people[a].stance.position;
      EXPECT_TRUE(IsFree(site, at, 0.28));
      EXPECT_GT(simulation::Length(at - placed.robot.position()), 0.65);
      for (std::size_t b = 0; b < a; ++b) {
        EXPECT_GT(simulation::Length(at - placed.people[b].stance.position), 0.5);
      }
    }
  }
  EXPECT_GT(most, 5U);
  EXPECT_LE(most, 12U);
}

}  // namespace
}  // namespace coppice::robot::training
