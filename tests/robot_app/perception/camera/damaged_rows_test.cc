#include "robot_app/perception/camera/damaged_rows.h"

#include <gtest/gtest.h>

#include "robot_app/common/compressed_picture.h"
#include "robot_app/simulation/camera/rgbd_camera.h"
#include "robot_app/simulation/floor_scene.h"
#include "robot_app/simulation/shipped_files.h"

namespace coppice::robot::perception {
namespace {

// Of the simulated camera, as they come out of a JPEG, on a way through the institute.
class DamagedRows : public testing::Test {
 protected:
  DamagedRows() {
    const simulation::Floor floor = *simulation::FindFloor(simulation::kInstitute);
    scene_ = simulation::Scene(simulation::MakeStillScene(floor));
  }

  simulation::RgbdPicture Taken(const simulation::Pose2& pose, double damaged) {
    simulation::SeenPerson person;
    person.stance.position = {pose.x + 2.5, pose.y + 0.4};
    auto taken = camera_.Take(scene_, {person}, pose, 1.35, {false, damaged});
    taken.colour = *DecodeJpeg(EncodeJpeg(taken.colour));
    return taken;
  }
  simulation::RgbdPicture Taken(int place, double damaged) {
    return Taken({static_cast<double>(place), 0, 0.7 * place}, damaged);
  }
  static double Share(const simulation::RgbdPicture& taken) {
    return TornShare(taken.colour, taken.depth);
  }

  simulation::Scene scene_;
  simulation::RgbdCamera camera_{{}, 1};
};

TEST_F(DamagedRows, NoUndamagedPictureLooksDamaged) {
  for (int place = 0; place < 48; place += 2) EXPECT_EQ(Share(Taken(place, 0)), 0) << place;
}

// Posters in a row, the joints of the tiles all along.
TEST_F(DamagedRows, NorDoesOneThatLooksStraightAtAWall) {
  for (const simulation::Pose2& pose : {simulation::Pose2{44, 0, 0},
                                        {44, 0, simulation::kPi},
                                        {46, 2, simulation::kPi / 2},
                                        {20, 0, 0}}) {
    EXPECT_EQ(Share(Taken(pose, 0)), 0) << pose.x << " " << pose.yaw;
  }
}

TEST_F(DamagedRows, AGaugeSeesOneInTenOnTheWayAndThatItIsMended) {
  TornGauge gauge;
  const auto add = [&](int place, double damaged) {
    const simulation::RgbdPicture taken = Taken(place, damaged);
    gauge.Add(taken.colour, taken.depth);
  };
  for (int place = 0; place < 30; ++place) add(place, 0.1);
  EXPECT_TRUE(gauge.is_damaged()) << gauge.share();
  for (int place = 0; place < 30; ++place) add(place, 0);
  EXPECT_FALSE(gauge.is_damaged()) << gauge.share();
}

TEST_F(DamagedRows, OnePictureAloneSaysNothing) {
  TornGauge gauge;
  const simulation::RgbdPicture taken = Taken(4, 0.05);
  EXPECT_GT(Share(taken), 0);
  gauge.Add(taken.colour, taken.depth);
  EXPECT_FALSE(gauge.is_damaged());
}

TEST_F(DamagedRows, WhatShowsNothingIsNotDamaged) {
  EXPECT_EQ(TornShare(Picture(640, 480), DepthPicture(640, 480)), 0);
  EXPECT_EQ(TornShare(Picture(5, 1), DepthPicture(5, 1)), 0);
  EXPECT_EQ(TornShare(Picture(), DepthPicture()), 0);
  EXPECT_EQ(TornShare(Taken(4, 0.5).colour, DepthPicture()), 0) << "no depth, no verdict";
}

}  // namespace
}  // namespace coppice::robot::perception
