#include "bt_core/live/pictures/picture_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

LivePicture Picture(const std::string& name, std::uint32_t width, std::uint32_t height) {
  return {name, "", width, height, std::vector<std::uint8_t>(std::size_t{3} * width * height)};
}

TEST(PictureSet, KeepsTheNewestOfEachName) {
  PictureSet set;
  EXPECT_TRUE(set.Put(Picture("face", 64, 32)));
  EXPECT_TRUE(set.Put(Picture("ears", 1, 1)));
  EXPECT_TRUE(set.Put(Picture("face", 8, 4)));
  ASSERT_THAT(set.all(), SizeIs(2));
  EXPECT_EQ(set.all().at("face").width, 8u);
  set.Clear();
  EXPECT_TRUE(set.empty());
}

TEST(PictureSet, RefusesWhatIsNoPicture) {
  PictureSet set;
  EXPECT_THAT(set.Put(Picture("", 1, 1)).problem(), HasSubstr("1 to 64 bytes, this one 0"));
  EXPECT_FALSE(set.Put(Picture(std::string(65, 'x'), 1, 1)));
  EXPECT_THAT(set.Put(Picture("face", 0, 32)).problem(), HasSubstr("it has 0 x 32"));
  LivePicture short_one = Picture("face", 2, 2);
  short_one.rgb.pop_back();
  EXPECT_THAT(set.Put(short_one).problem(), HasSubstr("expected 12 bytes of colour for 2 x 2"));
  LivePicture wordy = Picture("face", 2, 2);
  wordy.text = std::string(257, 'x');
  EXPECT_THAT(set.Put(wordy).problem(), HasSubstr("its text has 257 bytes"));
  EXPECT_TRUE(set.empty());
}

TEST(PictureSet, ASideThatOverflowsIsNoPicture) {
  PictureSet set;
  LivePicture picture = Picture("face", 1, 1);
  picture.width = picture.height = 0x80000000;  // their product is 0 in 32 and in 62 bits
  EXPECT_FALSE(set.Put(picture));
  picture.rgb.clear();
  EXPECT_FALSE(set.Put(picture));
}

TEST(PictureSet, AllTogetherHaveLimits) {
  PictureSet set;
  EXPECT_TRUE(set.Put(Picture("face", 64, 63)));
  EXPECT_THAT(set.Put(Picture("back", 65, 1)).problem(), HasSubstr("2 pictures of 4097 pixels"));
  EXPECT_TRUE(set.Put(Picture("back", 64, 1)));
  EXPECT_TRUE(set.Put(Picture("face", 1, 1))) << "what it replaces does not count";
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(set.Put(Picture("lamp" + std::to_string(i), 1, 1)));
  EXPECT_THAT(set.Put(Picture("one more", 1, 1)).problem(), HasSubstr("9 pictures"));
  EXPECT_THAT(set.all(), SizeIs(8));
}

}  // namespace
}  // namespace coppice
