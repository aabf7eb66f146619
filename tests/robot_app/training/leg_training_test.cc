#include "robot_app/training/leg_training.h"

#include <gtest/gtest.h>

#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::training {
namespace {

using perception::LegClassifier;

std::string TextOf(const LegClassifier& classifier) {
  const TemporaryFolder folder;
  EXPECT_TRUE(classifier.Save(folder.Path("classifier.yaml")));
  return ReadFile(folder.Path("classifier.yaml"));
}

TEST(LegTraining, TheSameOptionsLearnTheSameToTheLastBit) {
  LegTrainingOptions options;
  options.learning.scans = 20;
  options.learning.trees = {10, 2};
  const auto first = TrainLegs(options, [](double) {});
  const auto second = TrainLegs(options, [](double) {});
  ASSERT_TRUE(first) << first.problem();
  EXPECT_EQ(TextOf(*first), TextOf(*second));
}

TEST(LegTraining, OnAFloorNeverSeenFewOfThoseInFullViewAreMissed) {
  Diagnostics diagnostics;
  const auto floor = simulation::LoadFloor(
      SourceFolder() + "/robot_app/config/sites/institute/world.yaml", diagnostics);
  auto classifier =
      LegClassifier::Load(SourceFolder() + "/robot_app/perception/data/legs_in_scans.yaml");
  ASSERT_TRUE(classifier) << classifier.problem();
  perception::LegFinder finder({}, std::move(*classifier));
  const PeopleFigures figures = MeasureLegs(finder, SiteOf(*floor), 300, 0, 77);
  const Misses& free = figures.of(Distance::kNear, Occlusion::kFree);
  EXPECT_GT(free.people, 150);
  EXPECT_LE(free.share(), 0.06) << Table(figures);
  EXPECT_LE(figures.false_per_scan(), 0.1) << Table(figures);
  EXPECT_LE(figures.position_error, 0.15) << Table(figures);
}

}  // namespace
}  // namespace coppice::robot::training
