#include "robot_app/slam/map/slam_mapper.h"

#include <gtest/gtest.h>

#include "robot_app/training/slam_figures.h"
#include "tests/support/folders.h"

namespace coppice::robot::slam {
namespace {

// The west end of the shipped institute's corridor, with the station.
class SlamMapperTest : public testing::Test {
 protected:
  SlamMapperTest() {
    Diagnostics diagnostics;
    const std::string app = SourceFolder() + "/robot_app";
    floor_ = *simulation::LoadFloor(app + "/config/sites/institute/world.yaml", diagnostics);
    sensors_ = *training::SensorsOf(*RobotDescription::Load(app + "/description/sobi.urdf"));
    mapper_.step = 0.9;
    mapper_.turn = 0.6;
  }

  training::SlamResult Run(const std::vector<double>& lights) const {
    const training::SlamStudy study{
        floor_, sensors_, vocabulary_, classifier_, {{-0.8, 0}, {3, 0.2}, {-0.6, 0}, {-1, 0}},
        lights, 3,        mapper_,     true};
    return training::MeasureSlam(study, [](double) {});
  }

  simulation::Floor floor_;
  training::RobotSensors sensors_;
  const Vocabulary vocabulary_ =
      *Vocabulary::Load(SourceFolder() + "/robot_app/slam/data/vocabulary.txt");
  const PlaceClassifier classifier_ =
      *PlaceClassifier::Load(SourceFolder() + "/robot_app/slam/data/places_in_clouds.yaml");
  MapperSettings mapper_;
};

TEST_F(SlamMapperTest, ASecondSessionThatBeginsElsewhereIsJoined) {
  const training::SlamResult result = Run({1, 0.3});
  EXPECT_EQ(result.figures.joined, 1);
  EXPECT_EQ(result.figures.false_closures, 0);
  EXPECT_GT(result.figures.by_picture, 0);
  EXPECT_LT(result.figures.error, 0.1);
  EXPECT_EQ(result.map.names.size(), 2U);
}

TEST_F(SlamMapperTest, ItGoesOnWithAMapThatWasSaved) {
  const training::SlamResult result = Run({1});
  SlamMapper again(vocabulary_, classifier_, mapper_);
  ASSERT_TRUE(again.Resume(result.map));
  EXPECT_EQ(again.graph().poses().size(), result.map.graph.poses.size());
  again.BeginSession("later");
  EXPECT_FALSE(again.IsJoined());
  EXPECT_TRUE(again.IsDue(Pose3::Identity()));
}

TEST_F(SlamMapperTest, KeyFramesThatWerePutAwayComeBackAndCloseLoops) {
  mapper_.working = 8;
  const training::SlamResult result = Run({1, 1});
  EXPECT_GT(result.map.key_frames.size(), 20U);
  EXPECT_EQ(result.figures.joined, 1);
  EXPECT_GT(result.figures.from_disk, 2);
  EXPECT_EQ(result.figures.most_working, 8U);
  EXPECT_EQ(result.figures.false_closures, 0);
}

TEST_F(SlamMapperTest, TheDepthOfTheCamerasIsKeptIndoorsOnly) {
  for (const Surroundings place : {Surroundings::kIndoor, Surroundings::kHall}) {
    SlamMapper mapper(vocabulary_, classifier_, mapper_);
    mapper.environment().Force(place);
    mapper.BeginSession("one");
    Sight sight;
    sight.pictures.push_back({{}, sensors_.cameras[0], {{0, 0, 1}, {{1, 0, 0.5F}}}});
    mapper.Add(sight);
    EXPECT_EQ(mapper.key_frames()[0]->camera_clouds.size(), place == Surroundings::kIndoor ? 1 : 0);
  }
}

TEST_F(SlamMapperTest, AWorkingMemoryThatIsTooSmallForTheMapIsKept) {
  mapper_.working = 5;
  const training::SlamResult result = Run({1});
  EXPECT_GT(result.map.key_frames.size(), 8U);
  EXPECT_EQ(result.figures.false_closures, 0);
}

}  // namespace
}  // namespace coppice::robot::slam
