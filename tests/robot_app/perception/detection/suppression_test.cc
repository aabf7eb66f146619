#include "robot_app/perception/detection/suppression.h"

#include <gtest/gtest.h>

namespace coppice::robot::perception {
namespace {

constexpr SightingKind kPerson = SightingKind::kPerson;

TEST(Overlap, IsOneForTheSameBoxAndNothingForBoxesApart) {
  const Box box{10, 20, 30, 40};
  EXPECT_DOUBLE_EQ(Overlap(box, box), 1);
  EXPECT_DOUBLE_EQ(Overlap(box, {40, 20, 30, 40}), 0);
  EXPECT_DOUBLE_EQ(Overlap(box, {25, 20, 30, 40}), 1 / 3.0);
}

TEST(Suppress, KeepsTheSurestOfBoxesForOnePerson) {
  const auto kept = Suppress({{kPerson, {0, 0, 10, 20}, 0.6}, {kPerson, {1, 0, 10, 20}, 0.9}}, 0.5);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_DOUBLE_EQ(kept[0].confidence, 0.9);
}

TEST(Suppress, KeepsTwoWhoStandApart) {
  EXPECT_EQ(Suppress({{kPerson, {0, 0, 10, 20}, 0.6}, {kPerson, {8, 0, 10, 20}, 0.9}}, 0.5).size(),
            2U);
}

TEST(Nesting, IsTheShareOfTheSmallerBoxInTheOther) {
  EXPECT_DOUBLE_EQ(Nesting({0, 0, 100, 100}, {10, 10, 10, 20}), 1);
  EXPECT_DOUBLE_EQ(Nesting({10, 10, 10, 20}, {15, 0, 100, 100}), 0.5);
  EXPECT_DOUBLE_EQ(Nesting({0, 0, 1, 1}, {2, 2, 1, 1}), 0);
}

TEST(Suppress, DropsTheLessSureOfABoxInABoxOnlyIfAsked) {
  const std::vector<Sighting> two = {{kPerson, {0, 0, 40, 100}, 0.6},
                                     {kPerson, {10, 50, 20, 50}, 0.9}};
  EXPECT_EQ(Suppress(two, 0.5).size(), 2U);
  const auto kept = Suppress(two, 0.5, 0.8);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_DOUBLE_EQ(kept[0].confidence, 0.9);
}

TEST(Suppress, KeepsAFaceInAPerson) {
  const Box box{0, 0, 10, 10};
  EXPECT_EQ(Suppress({{kPerson, box, 0.9}, {SightingKind::kFace, box, 0.8}}, 0.5).size(), 2U);
}

TEST(Suppress, KeepsOneOfAFaceWithAndWithoutMask) {
  const Box box{0, 0, 10, 10};
  const auto kept = Suppress(
      {{SightingKind::kFaceWithoutMask, box, 0.8}, {SightingKind::kFaceWithMask, box, 0.9}}, 0.5);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].kind, SightingKind::kFaceWithMask);
}

}  // namespace
}  // namespace coppice::robot::perception
