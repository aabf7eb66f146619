#include "robot_app/perception/sightings/joined_sightings.h"

#include <gtest/gtest.h>

namespace coppice::robot::perception {
namespace {

PlacedSighting At(SightingKind kind, double x, double confidence) {
  PlacedSighting placed;
  placed.sighting = {kind, {}, confidence};
  placed.place.position = {x, 0};
  placed.place.by = RangedBy::kDepth;
  return placed;
}

TEST(Join, MakesOnePersonOfABodyAndItsFaceWhereTheBodyIs) {
  const auto people =
      Join({At(SightingKind::kFaceWithoutMask, 2.2, 0.95), At(SightingKind::kPerson, 2, 0.6)});
  ASSERT_EQ(people.size(), 1U);
  EXPECT_DOUBLE_EQ(people[0].position.x(), 2);
  EXPECT_EQ(people[0].has_mask, false);
  EXPECT_DOUBLE_EQ(people[0].probability, 0.95);
  EXPECT_EQ(people[0].modality, Modality::kCamera);
}

TEST(Join, MakesAPersonOfAFaceAlone) {
  const auto people = Join({At(SightingKind::kFaceWithMask, 2, 0.8)});
  ASSERT_EQ(people.size(), 1U);
  EXPECT_EQ(people[0].has_mask, true);
}

TEST(Join, KeepsTwoWhoStandApart) {
  EXPECT_EQ(Join({At(SightingKind::kPerson, 2, 0.8), At(SightingKind::kPerson, 2.6, 0.8)}).size(),
            2U);
}

TEST(Join, KnowsNoMaskOfAFaceWithoutKind) {
  EXPECT_FALSE(Join({At(SightingKind::kFace, 2, 0.8)}).at(0).has_mask);
}

TEST(Join, LeavesOutWhoHasNoPlace) {
  PlacedSighting nowhere = At(SightingKind::kPerson, 2, 0.9);
  nowhere.place.by = RangedBy::kNothing;
  EXPECT_TRUE(Join({nowhere}).empty());
}

}  // namespace
}  // namespace coppice::robot::perception
