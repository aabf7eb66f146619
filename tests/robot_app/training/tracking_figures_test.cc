#include "robot_app/training/tracking_figures.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/support/folders.h"

namespace coppice::robot::training {
namespace {

perception::PersonClassifier ShippedClassifier() {
  auto classifier = perception::PersonClassifier::Load(
      SourceFolder() + "/robot_app/perception/data/people_in_clouds.yaml");
  EXPECT_TRUE(classifier) << classifier.problem();
  return std::move(*classifier);
}

perception::PeopleFinder Shipped() { return {{}, ShippedClassifier()}; }

// Ten people who cross, stop, meet and hide behind each other, three times.
const std::vector<TrackingFigures>& Crowds() {
  static const std::vector<TrackingFigures> crowds = [] {
    std::vector<TrackingFigures> figures;
    for (const std::uint64_t seed : {31, 32, 33}) {
      TrackingScenario scenario;
      scenario.seconds = 40;
      scenario.seed = seed;
      perception::PeopleFinder finder = Shipped();
      figures.push_back(MeasureTracking({&finder, nullptr, nullptr}, scenario));
    }
    return figures;
  }();
  return crowds;
}

TEST(TrackingFigures, OfTenPeopleNearlyAllAreFollowedNearlyAlways) {
  for (const TrackingFigures& figures : Crowds()) {
    EXPECT_GT(figures.mot.people, 1500);
    EXPECT_GE(figures.mot.mota(), 0.9) << Summary(figures);
    EXPECT_LE(figures.mot.position_error(), 0.12) << Summary(figures);
  }
}

TEST(TrackingFigures, TheyHardlyEverGetAnotherNumber) {
  int switches = 0;
  double person_minutes = 0;
  for (const TrackingFigures& figures : Crowds()) {
    switches += figures.mot.switches;
    person_minutes += figures.person_minutes;
  }
  EXPECT_LE(switches / person_minutes, 0.5);
}

// The front and the rear camera as they look while the lidar is dead, alone or with the laser.
TrackingFigures WithoutTheLidar(bool with_laser) {
  std::vector<perception::PeopleInPictures> people;
  const auto detector = perception::MakeDetector({});
  EXPECT_TRUE(detector) << detector.problem();
  for (int i = 0; i < 2; ++i) people.emplace_back(**detector, ShippedClassifier());
  const std::vector<Mount> mounts = {{{0.17, 0, 0}, 1.4}, {{-0.17, 0, simulation::kPi}, 1.4}};
  CameraPair cameras(mounts, std::move(people), {0.2, 2}, 31);
  auto legs = perception::LegClassifier::Load(SourceFolder() +
                                              "/robot_app/perception/data/legs_in_scans.yaml");
  EXPECT_TRUE(legs) << legs.problem();
  perception::LegFinder laser({}, std::move(*legs));
  TrackingScenario scenario;
  scenario.seconds = 20;
  scenario.seed = 31;
  return MeasureTracking({nullptr, &cameras, with_laser ? &laser : nullptr}, scenario);
}

TEST(TrackingFigures, WithoutTheLidarWhoIsBeforeACameraIsFollowed) {
  const TrackingFigures figures = WithoutTheLidar(false);
  EXPECT_GT(figures.mot.people, 100);
  EXPECT_GE(figures.mot.mota(), 0.75) << Summary(figures);
  EXPECT_LE(figures.mot.position_error(), 0.12) << Summary(figures);
}

TEST(TrackingFigures, WithoutTheLidarEverybodyAroundIsFollowedByCamerasAndLegs) {
  const TrackingFigures figures = WithoutTheLidar(true);
  EXPECT_GT(figures.all_round.people, 800);
  EXPECT_GE(figures.all_round.mota(), 0.75) << Summary(figures);
  EXPECT_LE(figures.all_round.position_error(), 0.12) << Summary(figures);
}

TEST(TrackingFigures, InAnEmptyHallNobodyIsFollowed) {
  TrackingScenario scenario;
  scenario.people = 0;
  scenario.seconds = 20;
  perception::PeopleFinder finder = Shipped();
  const TrackingFigures figures = MeasureTracking({&finder, nullptr, nullptr}, scenario);
  EXPECT_GT(figures.turns, 100);
  EXPECT_EQ(figures.mot.extra, 0);
}

}  // namespace
}  // namespace coppice::robot::training
