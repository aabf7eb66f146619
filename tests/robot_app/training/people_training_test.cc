#include "robot_app/training/people_training.h"

#include <gtest/gtest.h>

#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::training {
namespace {

using perception::PeopleFinder;
using perception::PersonClassifier;

std::string TextOf(const PersonClassifier& classifier) {
  const TemporaryFolder folder;
  EXPECT_TRUE(classifier.Save(folder.Path("classifier.yaml")));
  return ReadFile(folder.Path("classifier.yaml"));
}

PeopleFigures MeasureShipped(bool with_picture, int scans) {
  Diagnostics diagnostics;
  const auto floor = simulation::LoadFloor(
      SourceFolder() + "/robot_app/config/sites/institute/world.yaml", diagnostics);
  auto classifier =
      PersonClassifier::Load(SourceFolder() + "/robot_app/perception/data/people_in_clouds.yaml");
  perception::FinderOptions options;
  options.candidates.with_depth_steps = with_picture;
  PeopleFinder finder(options, std::move(*classifier));
  return MeasurePeople(finder, SiteOf(*floor), scans, 77);
}

// What both tests look at.
const PeopleFigures& WithPicture() {
  static const PeopleFigures figures = MeasureShipped(true, 200);
  return figures;
}

int MissedNear(const PeopleFigures& figures) {
  int missed = 0;
  for (const Misses& misses : figures.misses[0]) missed += misses.missed;
  return missed;
}

TEST(PeopleTraining, TheSameOptionsLearnTheSameToTheLastBit) {
  LearningRounds options;
  options.scans = 12;
  options.trees = {10, 2};
  const auto first = TrainPeople(options, [](double) {});
  const auto second = TrainPeople(options, [](double) {});
  ASSERT_TRUE(first) << first.problem();
  EXPECT_EQ(TextOf(*first), TextOf(*second));
}

TEST(PeopleTraining, OnAFloorNeverSeenHardlyAnybodyNearIsMissedOrInvented) {
  const PeopleFigures& figures = WithPicture();
  const Misses& free = figures.of(Distance::kNear, Occlusion::kFree);
  EXPECT_GT(free.people, 150);
  EXPECT_LE(free.share(), 0.03);
  EXPECT_LE(figures.of(Distance::kNear, Occlusion::kHalfHidden).share(), 0.1);
  EXPECT_LE(figures.false_per_scan(), 0.05);
  EXPECT_LE(figures.position_error, 0.12);
}

TEST(PeopleTraining, FewerPeopleAreMissedWithThePictureThanWithDistanceAlone) {
  EXPECT_LT(MissedNear(WithPicture()), MissedNear(MeasureShipped(false, 200)));
}

}  // namespace
}  // namespace coppice::robot::training
