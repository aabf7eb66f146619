#include "robot_app/perception/camera/people_in_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::robot::perception {
namespace {

TEST(IsCovered, APictureOfOneShadeButNotOneOfSomething) {
  Picture picture(64, 48);
  EXPECT_TRUE(IsCovered(picture, {}));
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    picture.rgb[i] = static_cast<std::uint8_t>(i / 3 % 64 < 32 ? 0 : 200);
  }
  EXPECT_FALSE(IsCovered(picture, {}));
}

TEST(IsCovered, APlainWallIsNone) {
  DepthPicture depth(64, 48);
  EXPECT_TRUE(IsCovered(Picture(64, 48), depth)) << "nothing is so near";
  std::fill(depth.millimetres.begin(), depth.millimetres.end(), std::uint16_t{400});
  EXPECT_FALSE(IsCovered(Picture(64, 48), depth));
}

TEST(PeopleInPictures, PutsWhatTheDetectorSeesWhereTheDepthSays) {
  DetectorChoice choice;
  choice.built_in = "people";
  const auto detector = MakeDetector(choice);
  ASSERT_TRUE(detector);
  PeopleInPictures people(**detector, std::nullopt);
  Ranges ranges;
  ranges.lens = {600, 600, 32, 24};
  EXPECT_TRUE(people.Find(Picture(64, 48), ranges).empty()) << "too small for anybody";
  ranges.depth = DepthPicture(20, 10);  // of another size
  EXPECT_TRUE(people.Find(Picture(64, 48), ranges).empty());
}

}  // namespace
}  // namespace coppice::robot::perception
