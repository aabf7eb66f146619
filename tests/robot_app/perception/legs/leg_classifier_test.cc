#include "robot_app/perception/legs/leg_classifier.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/folders.h"

namespace coppice::robot::perception {
namespace {

TEST(LegClassifier, TheShippedOneIsThere) {
  const auto classifier =
      LegClassifier::Load(SourceFolder() + "/robot_app/perception/data/legs_in_scans.yaml");
  EXPECT_TRUE(classifier) << classifier.problem();
}

TEST(LegClassifier, AFileOfAnotherKindNamesTheCommandThatWritesTheRightOne) {
  const auto classifier =
      LegClassifier::Load(SourceFolder() + "/robot_app/perception/data/people_in_clouds.yaml");
  ASSERT_FALSE(classifier);
  EXPECT_THAT(classifier.problem(), testing::HasSubstr("coppice-train legs"));
}

TEST(LegClassifier, LearnsFromBothKindsOnly) {
  EXPECT_FALSE(LegClassifier::Train({{LegFeatures{}, true}}, {}));
}

}  // namespace
}  // namespace coppice::robot::perception
