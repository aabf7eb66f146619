#include "robot_app/perception/detection/network_classes.h"

#include <gtest/gtest.h>

namespace coppice::robot::perception {
namespace {

TEST(ParseClasses, KnowsPeopleAndMasksHoweverTheyAreWritten) {
  const auto classes = ParseClasses("bicycle\nPerson\r\nwith_mask\nNo-Mask\n\n");
  ASSERT_TRUE(classes) << classes.problem();
  ASSERT_EQ(classes->size(), 4U);
  EXPECT_FALSE((*classes)[0]);
  EXPECT_EQ((*classes)[1], SightingKind::kPerson);
  EXPECT_EQ((*classes)[2], SightingKind::kFaceWithMask);
  EXPECT_EQ((*classes)[3], SightingKind::kFaceWithoutMask);
}

TEST(ParseClasses, RefusesNamesOfNoUseAndTellsThoseOfUse) {
  const auto classes = ParseClasses("cat\ndog\n");
  ASSERT_FALSE(classes);
  EXPECT_NE(classes.problem().find("person"), std::string::npos) << classes.problem();
}

TEST(UsualClasses, ArePeopleFirst) {
  for (const int count : {1, 80}) {
    const auto classes = UsualClasses(count);
    ASSERT_TRUE(classes);
    EXPECT_EQ(classes->size(), static_cast<std::size_t>(count));
    EXPECT_EQ((*classes)[0], SightingKind::kPerson);
  }
}

TEST(UsualClasses, AreNotGuessedForAnotherCount) { EXPECT_FALSE(UsualClasses(3)); }

}  // namespace
}  // namespace coppice::robot::perception
