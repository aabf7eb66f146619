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

  Picture Taken(int place, double damaged) {
    simulation::SeenPerson person;
    person.stance.position = {place + 2.5, 0.4};
    const simulation::Pose2 pose{static_cast<double>(place), 0, 0.7 * place};
    const auto taken = camera_.Take(scene_, {person}, pose, 1.35, {false, damaged});
    return *DecodeJpeg(EncodeJpeg(taken.colour));
  }

  simulation::Scene scene_;
  simulation::RgbdCamera camera_{{}, 1};
};

TEST_F(DamagedRows, NoUndamagedPictureLooksDamaged) {
  for (int place = 0; place < 30; place += 2) EXPECT_LT(TornShare(Taken(place, 0)), 0.01) << place;
}

TEST_F(DamagedRows, AGaugeSeesOneInTenOnTheWayAndThatItIsMended) {
  TornGauge gauge;
  for (int place = 0; place < 30; ++place) gauge.Add(Taken(place, 0.1));
  EXPECT_TRUE(gauge.is_damaged()) << gauge.share();
  for (int place = 0; place < 30; ++place) gauge.Add(Taken(place, 0));
  EXPECT_FALSE(gauge.is_damaged()) << gauge.share();
}

TEST_F(DamagedRows, OnePictureAloneSaysNothing) {
  TornGauge gauge;
  gauge.Add(Taken(4, 0.1));
  EXPECT_FALSE(gauge.is_damaged());
}

TEST_F(DamagedRows, WhatShowsNothingIsNotDamaged) {
  EXPECT_EQ(TornShare(Picture(640, 480)), 0);
  EXPECT_EQ(TornShare(Picture(5, 1)), 0);
  EXPECT_EQ(TornShare(Picture()), 0);
}

}  // namespace
}  // namespace coppice::robot::perception
