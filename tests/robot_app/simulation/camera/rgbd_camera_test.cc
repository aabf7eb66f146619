#include "robot_app/simulation/camera/rgbd_camera.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>

#include "robot_app/common/compressed_picture.h"
#include "robot_app/simulation/floor_scene.h"
#include "tests/support/folders.h"

namespace coppice::robot::simulation {
namespace {

constexpr double kLensHeight = 1.35;

// A room of 10 m by 6 m; the camera stands in its middle and looks along x.
class RgbdCameraTest : public testing::Test {
 protected:
  RgbdCameraTest() {
    const std::vector<Vec2> corners = {{-5, -3}, {5, -3}, {5, 3}, {-5, 3}, {-5, -3}};
    for (std::size_t i = 1; i < corners.size(); ++i) {
      still_.panels.push_back({{corners[i - 1], corners[i]}, 2.5, Material::kWall});
    }
    still_.ceiling = 2.5;
  }

  RgbdPicture Take(const std::vector<SeenPerson>& people = {}, const CameraFault& fault = {},
                   double yaw = 0) const {
    return RgbdCamera({}, 1).Take(Scene(still_), people, {0, 0, yaw}, kLensHeight, fault);
  }
  static SeenPerson PersonAt(Vec2 place, double heading = kPi) {
    SeenPerson person;
    person.stance.position = place;
    person.stance.heading = heading;
    return person;
  }

 public:
  // Of the pixel in which a point of the map is seen, in metres.
  static double DepthAt(const RgbdPicture& picture, double x, double y, double z) {
    const Lens lens = RgbdOptions().lens;
    return 0.001 * picture.depth.at(
                       static_cast<int>(std::lround(lens.cx - lens.fx * y / x)),
                       static_cast<int>(std::lround(lens.cy + lens.fy * (kLensHeight - z) / x)));
  }

 protected:
  StillScene still_;
};

// Mean of the colours of a picture, 0..255.
double Brightness(const RgbdPicture& picture) {
  double sum = 0;
  for (const std::uint8_t byte : picture.colour.rgb) sum += byte;
  return sum / static_cast<double>(picture.colour.rgb.size());
}

// How much neighbours differ on a bare wall.
double Grain(const RgbdPicture& picture) {
  double sum = 0;
  for (int row = 150; row < 170; ++row) {
    for (int column = 300; column < 340; ++column) {
      sum += std::abs(picture.colour.at(column, row)[0] - picture.colour.at(column + 1, row)[0]);
    }
  }
  return sum;
}

TEST_F(RgbdCameraTest, LessLightIsBalancedUpToALimitAndMakesThePictureNoisy) {
  const RgbdPicture full = Take();
  still_.light = 0.25;
  const RgbdPicture dim = Take();
  still_.light = 0.02;
  const RgbdPicture dark = Take();
  EXPECT_NEAR(Brightness(dim), Brightness(full), 3);
  EXPECT_GT(Grain(dim), 2 * Grain(full));
  EXPECT_LT(Brightness(dark), 0.3 * Brightness(full));
}

TEST_F(RgbdCameraTest, APosterIsManyColouredAndItsWallIsNot) {
  const auto colours = [&](int first, int last) {
    std::set<Colour> found;
    RgbdOptions clear;
    clear.colour_noise = 0;
    const RgbdPicture seen = RgbdCamera(clear, 1).Take(Scene(still_), {}, {0, 0, 0}, kLensHeight);
    for (int column = first; column < last; ++column) found.insert(seen.colour.at(column, 200));
    return found.size();
  };
  const std::size_t bare = colours(280, 370);
  still_.AddBox({{4.99, 0}, {0.004, 1.4}, 0}, 2.2, Material::kPoster);
  EXPECT_GT(colours(280, 370), bare + 4);
}

TEST_F(RgbdCameraTest, DepthIsAlongTheOpticalAxisTheSameAllOverAWall) {
  const RgbdPicture seen = Take();
  for (const double y : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
    EXPECT_NEAR(DepthAt(seen, 5, y, 1.0), 5, 0.3) << y;
  }
}

TEST_F(RgbdCameraTest, TheFloorIsSeenWhereItIs) {
  const RgbdPicture seen = Take();
  for (const double x : {3.6, 4.0, 4.5}) EXPECT_NEAR(DepthAt(seen, x, 0.2, 0), x, 0.25) << x;
}

TEST_F(RgbdCameraTest, LooksWhereItIsTurned) {
  EXPECT_NEAR(DepthAt(Take({}, {}, kPi / 2), 3, 0, 1.0), 3, 0.15);
}

TEST_F(RgbdCameraTest, APersonIsNearerThanTheWallBehindAndBetweenFeetAndHead) {
  const RgbdPicture seen = Take({PersonAt({3.5, 0})});
  EXPECT_NEAR(DepthAt(seen, 3.5, 0, 1.2), 3.4, 0.2);
  EXPECT_NEAR(DepthAt(seen, 3.5, 0, 1.65), 3.4, 0.2);
  EXPECT_NEAR(DepthAt(seen, 3.5, 0, 1.95), 5, 0.4) << "above the head";
  EXPECT_NEAR(DepthAt(seen, 3.5, 0.6, 1.2), 5, 0.4) << "beside the body";
}

TEST_F(RgbdCameraTest, ClothesHaveTheirColour) {
  SeenPerson person = PersonAt({3, 0});
  person.look.top = {200, 20, 20};
  const Colour chest = Take({person}).colour.at(326, 236 + 30);
  EXPECT_GT(chest[0], 3 * chest[1]);
  EXPECT_GT(chest[0], 3 * chest[2]);
}

TEST_F(RgbdCameraTest, OneSeesOverATableOntoItsTopAndTheWallBehind) {
  still_.AddBox({{4, 0}, {0.6, 1.2}, 0}, 0.75, Material::kFurniture);
  const RgbdPicture seen = Take();
  EXPECT_NEAR(DepthAt(seen, 4, 0.2, 0.75), 4, 0.2) << "the middle of its top";
  EXPECT_NEAR(DepthAt(seen, 3.7, 0.2, 0.4), 3.7, 0.2) << "its front";
  EXPECT_NEAR(DepthAt(seen, 5, 0.2, 1.0), 5, 0.3) << "the wall over it";
}

TEST_F(RgbdCameraTest, WhoStandsInFrontHidesWhoStandsBehind) {
  SeenPerson near = PersonAt({3.5, 0});
  SeenPerson far = PersonAt({4.5, 0});
  near.look.top = {20, 20, 200};
  far.look.top = {200, 20, 20};
  const Colour chest = Take({near, far}).colour.at(326, 236 + 40);
  EXPECT_GT(chest[2], 2 * chest[0]);
}

TEST_F(RgbdCameraTest, WhatIsTooNearOrTooFarHasNoDepth) {
  RgbdOptions options;
  options.max_depth = 4;
  const RgbdPicture seen = RgbdCamera(options, 1).Take(Scene(still_), {}, {0, 0, 0}, kLensHeight);
  EXPECT_EQ(DepthAt(seen, 5, 0, 1.2), 0);
}

TEST_F(RgbdCameraTest, ThereIsNoDepthBesideAnEdge) {
  const RgbdPicture seen = Take({PersonAt({3, 0})});
  int holes = 0;
  for (int column = 200; column < 450; ++column) holes += seen.depth.at(column, 260) == 0;
  EXPECT_GT(holes, 2);
  EXPECT_LT(holes, 40);
}

TEST_F(RgbdCameraTest, TheSameSeedGivesTheSamePicturesAndTheNoiseOfTwoDiffers) {
  RgbdCamera a({}, 7);
  RgbdCamera b({}, 7);
  const std::vector<SeenPerson> people = {PersonAt({3, 0.5})};
  const Scene scene(still_);
  const RgbdPicture first = a.Take(scene, people, {0, 0, 0}, kLensHeight);
  const RgbdPicture again = b.Take(scene, people, {0, 0, 0}, kLensHeight);
  EXPECT_EQ(first.colour.rgb, again.colour.rgb);
  EXPECT_EQ(first.depth.millimetres, again.depth.millimetres);
  EXPECT_NE(first.colour.rgb, a.Take(scene, people, {0, 0, 0}, kLensHeight).colour.rgb);
}

TEST_F(RgbdCameraTest, ACoveredLensSeesDarknessAndNoDepth) {
  const RgbdPicture seen = Take({PersonAt({3, 0})}, {true, 0});
  for (int column = 0; column < 640; column += 40) {
    EXPECT_LT(seen.colour.at(column, 200)[0], 16);
    EXPECT_EQ(seen.depth.at(column, 200), 0);
  }
}

TEST_F(RgbdCameraTest, DamageTakesAsManyRowsAsIsSaid) {
  const RgbdPicture whole = Take();
  const RgbdPicture broken = Take({}, {false, 0.3});
  int damaged = 0;
  for (int row = 0; row < 480; ++row) {
    bool differs = false;
    for (int column = 0; column < 640; ++column) {
      differs |= whole.depth.at(column, row) != broken.depth.at(column, row);
    }
    damaged += differs;
  }
  EXPECT_GT(damaged, 0.2 * 480);
  EXPECT_LT(damaged, 0.4 * 480);
}

// The picture of docs/robot.md: COPPICE_PICTURES=FOLDER writes it.
TEST(RgbdCameraInTheInstitute, SeesACorridorWithPeopleAtAllDistances) {
  Diagnostics diagnostics;
  const auto floor =
      LoadFloor(SourceFolder() + "/robot_app/config/sites/institute/world.yaml", diagnostics);
  ASSERT_TRUE(floor) << diagnostics.ToString();
  const Scene scene(MakeStillScene(*floor));
  std::vector<SeenPerson> people(4);
  const std::array<Vec2, 4> places = {{{12.6, 0.75}, {14.2, -0.7}, {15.5, 0.3}, {19, -0.4}}};
  for (std::size_t i = 0; i < people.size(); ++i) {
    people[i].look = RandomPersonLook(20 + i);
    people[i].look.wears_mask = i == 1;
    people[i].stance = {places[i], kPi + 0.5 * static_cast<double>(i), 0.4 * i, i > 0, 1.75};
  }
  const RgbdPicture seen = RgbdCamera({}, 1).Take(scene, people, {10, 0, 0}, kLensHeight);
  for (std::size_t i = 0; i < people.size(); ++i) {
    const double x = places[i].x - 10;
    const double chest = x - 0.15;
    const double noise = RgbdOptions().depth_noise * x * x;
    EXPECT_NEAR(RgbdCameraTest::DepthAt(seen, x, places[i].y, 1.2), chest, 0.1 + 3 * noise) << i;
  }
  if (const char* const folder = std::getenv("COPPICE_PICTURES")) {
    const std::vector<std::uint8_t> jpeg = EncodeJpeg(seen.colour, 90);
    std::ofstream(std::string(folder) + "/camera.jpg", std::ios::binary)
        .write(reinterpret_cast<const char*>(jpeg.data()), static_cast<long>(jpeg.size()));
  }
}

TEST_F(RgbdCameraTest, BehindWhatIsLowThereIsTheFloorWhereNoWallEndsTheView) {
  still_.panels.clear();
  still_.AddBox({{4, 0}, {0.6, 1.2}, 0}, 0.75, Material::kFurniture);
  RgbdOptions options;
  options.max_depth = 20;
  const RgbdPicture seen = RgbdCamera(options, 1).Take(Scene(still_), {}, {0, 0, 0}, kLensHeight);
  EXPECT_NEAR(DepthAt(seen, 12, 0, 0), 12, 1.5) << "seen over the box";
}

TEST_F(RgbdCameraTest, ALensWhoseHorizonIsARowOfItsOwnHasNoDepthThere) {
  RgbdOptions options;
  options.lens.cy = 240;
  still_.panels.clear();
  const RgbdPicture seen = RgbdCamera(options, 1).Take(Scene(still_), {}, {0, 0, 0}, kLensHeight);
  EXPECT_EQ(seen.depth.at(320, 240), 0);
}

TEST_F(RgbdCameraTest, FromOutsideOfAllWallsItSeesTheSkyAndTheFloor) {
  still_ = {};
  still_.light = 0.2;  // dusk
  const RgbdPicture seen = Take();
  EXPECT_NEAR(DepthAt(seen, 4, 0, 0), 4, 0.25);
  EXPECT_EQ(seen.depth.at(320, 10), 0);
}

TEST_F(RgbdCameraTest, InTheSunItMeasuresNoDepthBeyondTwoMetres) {
  still_ = {};
  still_.AddBox({{1.8, 0}, {0.6, 1.2}, 0}, 0.75, Material::kFurniture);
  const RgbdPicture seen = Take();
  const auto& depths = seen.depth.millimetres;
  const int farthest = *std::max_element(depths.begin(), depths.end());
  EXPECT_GT(farthest, 1000) << "the box";
  EXPECT_LT(farthest, 2100);
}

}  // namespace
}  // namespace coppice::robot::simulation
