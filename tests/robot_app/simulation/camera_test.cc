#include "robot_app/simulation/camera.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robot_app/simulation/jpeg.h"

namespace coppice::robot::simulation {
namespace {

// A room of 10 m by 6 m; a person stands 3 m ahead of the robot, a desk to the left.
constexpr char kRoom[] = R"(name: room
wall_height: 2.5
walls: [[[-5, -3], [5, -3], [5, 3], [-5, 3], [-5, -3]]]
furniture: [{name: desk, at: [2, 2], size: [0.8, 0.8], height: 0.75}]
people: [{name: Eve, speed: 1, path: [[3, 0], [3.1, 0]]}]
charging_station: {docked: [-4, 0, 0], staging: [-3, 0, 0]}
)";

class Camera : public testing::Test {
 protected:
  Camera() {
    Diagnostics diagnostics;
    const std::optional<Floor> floor = ParseFloor(kRoom, "room.yaml", diagnostics);
    EXPECT_TRUE(floor) << diagnostics.ToString();
    WorldOptions options;
    options.start = Pose2{0, 0, 0};
    world_.emplace(*floor, options);
  }

  std::optional<World> world_;
};

bool IsReddish(const Colour& colour) { return colour[0] > 2 * colour[1] && colour[0] > 60; }

TEST_F(Camera, SeesThePersonAheadInTheMiddleAndTheWallAround) {
  const Picture picture = RenderPicture(*world_, {});
  ASSERT_EQ(picture.rgb.size(), 3u * 320 * 240);
  EXPECT_TRUE(IsReddish(picture.at(160, 140)));  // clothes
  EXPECT_FALSE(IsReddish(picture.at(300, 140)));
  const Colour wall = picture.at(110, 110);
  EXPECT_GT(wall[0], 100);
  EXPECT_NEAR(wall[0], wall[1], 10);
}

TEST_F(Camera, TheFloorIsDarkerThanTheCeiling) {
  const Picture picture = RenderPicture(*world_, {});
  EXPECT_LT(picture.at(5, 239)[0], picture.at(160, 0)[0]);
}

TEST_F(Camera, LooksWhereItIsMounted) {
  CameraOptions rear;
  rear.mounting = {-0.2, 0, kPi};
  const Picture picture = RenderPicture(*world_, rear);
  for (int column = 0; column < 320; ++column) EXPECT_FALSE(IsReddish(picture.at(column, 140)));
}

TEST_F(Camera, WhatIsNearerHidesWhatIsBehind) {
  const Picture picture = RenderPicture(*world_, {});
  CameraOptions low;
  low.lens_height = 0.3;
  const Picture from_below = RenderPicture(*world_, low);
  // The desk, left of the middle, is as high as the horizon only for the low camera.
  EXPECT_NE(picture.at(20, 119), from_below.at(20, 119));
}

TEST_F(Camera, TheSameWorldGivesTheSamePicture) {
  EXPECT_EQ(RenderPicture(*world_, {}).rgb, RenderPicture(*world_, {}).rgb);
}

TEST_F(Camera, ThePictureIsAJpegFileOfAFewKilobytes) {
  const std::vector<std::uint8_t> jpeg = EncodeJpeg(RenderPicture(*world_, {}));
  ASSERT_GT(jpeg.size(), 2000u);
  EXPECT_LT(jpeg.size(), 30000u);
  EXPECT_EQ(jpeg[0], 0xff);
  EXPECT_EQ(jpeg[1], 0xd8);
  EXPECT_EQ(jpeg[jpeg.size() - 2], 0xff);
  EXPECT_EQ(jpeg.back(), 0xd9);
}

}  // namespace
}  // namespace coppice::robot::simulation
