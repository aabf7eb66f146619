#include "robot_app/slam/pictures/picture_places.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot_app/training/slam_tour.h"
#include "tests/support/folders.h"

namespace coppice::robot::slam {
namespace {

using simulation::Pose2;
using training::Stop;
using training::TourEyes;
using training::TourSettings;

// The shipped institute, seen in one session and in another one.
class PicturePlacesTest : public testing::Test {
 protected:
  PicturePlacesTest() {
    Diagnostics diagnostics;
    floor_ = *simulation::LoadFloor(SourceFolder() + "/robot_app/config/sites/institute/world.yaml",
                                    diagnostics);
    const auto robot = RobotDescription::Load(SourceFolder() + "/robot_app/description/sobi.urdf");
    sensors_ = *training::SensorsOf(*robot);
  }

  PictureFeatures Look(const Pose2& robot, double light, std::uint64_t session,
                       std::size_t camera = 0) const {
    TourSettings settings;
    settings.seed = session;
    settings.light = light;
    settings.people = session == 1 ? 0 : 4;
    TourEyes eyes(floor_, sensors_, settings);
    const auto seen = eyes.TakePicture({robot, robot, 0}, camera);
    return FindFeatures(seen.colour, seen.depth, sensors_.cameras[camera]);
  }

  void Remember(const std::vector<Pose2>& robots) {
    for (const Pose2& robot : robots) {
      known_.push_back(robot);
      places_.Add(static_cast<std::uint32_t>(known_.size() - 1),
                  std::make_shared<PictureFeatures>(Look(robot, 1, 1)));
    }
  }

  std::optional<PicturePlace> Find(const Pose2& robot, double light, std::size_t camera = 0) {
    return places_.Find(Look(robot, light, 2, camera), sensors_.cameras[camera],
                        [](std::uint32_t) { return true; });
  }

  // How far the place that was found is from the truth [m].
  double Off(const PicturePlace& place, const Pose2& robot) const {
    const Eigen::Vector3d at = place.match.relative.translation();
    const Pose2 found = Compose(known_[place.key_frame], {at.x(), at.y(), 0});
    return std::hypot(found.x - robot.x, found.y - robot.y);
  }

  simulation::Floor floor_;
  training::RobotSensors sensors_;
  const Vocabulary vocabulary_ =
      *Vocabulary::Load(SourceFolder() + "/robot_app/slam/data/vocabulary.txt");
  PicturePlaces places_{vocabulary_};
  std::vector<Pose2> known_;
};

TEST_F(PicturePlacesTest, ThePosterAboveTheStationIsRecognizedDirectlyAfterUndocking) {
  Remember({{-0.8, 0, M_PI}, {2, 0, 0}, {8, 0, 0}, {16, 0, M_PI}});
  const Pose2 undocked{-0.95, 0.1, M_PI - 0.1};
  for (const double light : {1.0, 0.1}) {
    const auto found = Find(undocked, light);
    ASSERT_TRUE(found) << light;
    EXPECT_TRUE(IsSure(found->match)) << light << ": " << found->match.inliers;
    EXPECT_EQ(found->key_frame, 0U);
    EXPECT_LT(Off(*found, undocked), 0.1) << light;
  }
}

TEST_F(PicturePlacesTest, TheCameraBehindRecognizesWhatTheOneInFrontHasSeen) {
  Remember({{-0.8, 0, M_PI}, {8, 0, 0}});
  const Pose2 turned{-1.0, 0, 0.05};
  const auto found = Find(turned, 1, 1);
  ASSERT_TRUE(found);
  EXPECT_TRUE(IsSure(found->match));
  EXPECT_LT(Off(*found, turned), 0.1);
}

TEST_F(PicturePlacesTest, AnOfficeIsNotTakenForAnotherThatIsFurnishedAlike) {
  Remember({{8, 3, M_PI / 2}, {16, 3, M_PI / 2}, {24, 3, M_PI / 2}, {8, 3, M_PI}, {16, 3, M_PI}});
  for (const Pose2& robot : {Pose2{32, 3, M_PI / 2}, Pose2{32.1, 3, M_PI}}) {
    const auto found = Find(robot, 1);
    EXPECT_FALSE(found && IsSure(found->match)) << found->match.inliers;
  }
}

TEST_F(PicturePlacesTest, WithCoveredLensesNothingIsRecognized) {
  Remember({{-0.8, 0, M_PI}});
  const PictureFeatures nothing =
      FindFeatures(Picture(640, 480), DepthPicture(640, 480), sensors_.cameras[0]);
  EXPECT_FALSE(places_.Find(nothing, sensors_.cameras[0], [](std::uint32_t) { return true; }));
}

TEST_F(PicturePlacesTest, WhatWasTakenOutIsNotFoundAndComesBackWhenItIsAddedAgain) {
  Remember({{-0.8, 0, M_PI}});
  const auto picture = std::make_shared<PictureFeatures>(Look({-0.8, 0, M_PI}, 1, 1));
  places_.Remove(0);
  EXPECT_FALSE(Find({-0.8, 0, M_PI}, 1));
  places_.Add(0, picture);
  EXPECT_TRUE(Find({-0.8, 0, M_PI}, 1));
}

TEST_F(PicturePlacesTest, OnlyWhatIsAskedForIsFound) {
  Remember({{-0.8, 0, M_PI}});
  const auto found = places_.Find(Look({-0.8, 0, M_PI}, 1, 2), sensors_.cameras[0],
                                  [](std::uint32_t key_frame) { return key_frame != 0; });
  EXPECT_FALSE(found);
}

}  // namespace
}  // namespace coppice::robot::slam
