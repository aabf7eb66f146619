#include "robot_app/simulation/appearance/person_picture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::simulation {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Extent {
  int left = 1 << 30, right = -1, top = 1 << 30, bottom = -1;
};

Extent ExtentOf(const PersonPicture& picture) {
  Extent extent;
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      if (picture.rgba[4 * (static_cast<std::size_t>(row) * picture.width + column) + 3] < 128) {
        continue;
      }
      extent = {std::min(extent.left, column), std::max(extent.right, column),
                std::min(extent.top, row), std::max(extent.bottom, row)};
    }
  }
  return extent;
}

TEST(PersonPicture, ReachesFromTheFeetToTheHead) {
  for (const int pixels : {60, 200, 900}) {
    const PersonPicture picture = DrawPerson({}, {}, pixels);
    const Extent extent = ExtentOf(picture);
    EXPECT_NEAR(extent.bottom - extent.top + 1, pixels, 0.04 * pixels);
    EXPECT_NEAR(extent.bottom + 1, picture.height, 0.02 * pixels);
    EXPECT_NEAR((extent.left + extent.right + 1) / 2.0, picture.width / 2.0, 0.02 * pixels);
  }
}

TEST(PersonPicture, IsNarrowerFromTheSide) {
  const Extent front = ExtentOf(DrawPerson({}, {}, 300));
  const Extent side = ExtentOf(DrawPerson({}, {kPi / 2, 0, false}, 300));
  EXPECT_LT(1.4 * (side.right - side.left), front.right - front.left);
}

TEST(PersonPicture, ALongStepIsWiderFromTheSideThanStanding) {
  const Extent stands = ExtentOf(DrawPerson({}, {kPi / 2, 0, false}, 300));
  const Extent walks = ExtentOf(DrawPerson({}, {kPi / 2, kPi / 2, true}, 300));
  EXPECT_GT(walks.right - walks.left, 1.5 * (stands.right - stands.left));
}

TEST(PersonPicture, TheSameLookAndViewGiveTheSamePicture) {
  const PersonLook look = RandomPersonLook(5);
  EXPECT_EQ(DrawPerson(look, {0.4, 1, true}, 200).rgba, DrawPerson(look, {0.4, 1, true}, 200).rgba);
}

TEST(PersonPicture, AMaskIsSeenFromTheFrontAndNotFromBehind) {
  PersonLook bare = RandomPersonLook(5);
  PersonLook masked = bare;
  masked.wears_mask = true;
  EXPECT_NE(DrawPerson(bare, {}, 200).rgba, DrawPerson(masked, {}, 200).rgba);
  EXPECT_EQ(DrawPerson(bare, {kPi, 0, false}, 200).rgba,
            DrawPerson(masked, {kPi, 0, false}, 200).rgba);
}

TEST(PersonPicture, ManyPeopleLookDifferent) {
  int same = 0;
  const auto first = DrawPerson(RandomPersonLook(0), {}, 60).rgba;
  for (int seed = 1; seed < 30; ++seed)
    same += DrawPerson(RandomPersonLook(seed), {}, 60).rgba == first;
  EXPECT_EQ(same, 0);
}

}  // namespace
}  // namespace coppice::robot::simulation
