#include "robot_app/simulation/jpeg.h"

#include <gtest/gtest.h>

namespace coppice::robot::simulation {
namespace {

Picture Gradient(int width, int height) {
  Picture picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.rgb.push_back(static_cast<std::uint8_t>(x * 7));
      picture.rgb.push_back(static_cast<std::uint8_t>(y * 11));
      picture.rgb.push_back(static_cast<std::uint8_t>((x * y) % 251));
    }
  }
  return picture;
}

// Offset of the segment with that marker; 0 if there is none.
std::size_t Find(const std::vector<std::uint8_t>& file, std::uint8_t marker) {
  std::size_t at = 2;
  while (at + 4 < file.size() && file[at] == 0xFF) {
    if (file[at + 1] == marker) return at;
    at += 2 + (std::size_t{file[at + 2]} << 8) + file[at + 3];
  }
  return 0;
}

TEST(Jpeg, IsAWholeFileOfTheSizeOfThePicture) {
  const std::vector<std::uint8_t> file = EncodeJpeg(Gradient(300, 40));
  ASSERT_GT(file.size(), 20U);
  EXPECT_EQ(file[0] << 8 | file[1], 0xFFD8) << "start of image";
  EXPECT_EQ(file[file.size() - 2] << 8 | file.back(), 0xFFD9) << "end of image";
  const std::size_t frame = Find(file, 0xC0);  // baseline
  ASSERT_NE(frame, 0U);
  EXPECT_EQ(file[frame + 5] << 8 | file[frame + 6], 40);
  EXPECT_EQ(file[frame + 7] << 8 | file[frame + 8], 300);
}

TEST(Jpeg, IsSmallerWithLessQuality) {
  const Picture picture = Gradient(64, 64);
  EXPECT_LT(EncodeJpeg(picture, 20).size(), EncodeJpeg(picture, 70).size());
  EXPECT_LT(EncodeJpeg(picture, 70).size(), EncodeJpeg(picture, 100).size());
}

}  // namespace
}  // namespace coppice::robot::simulation
