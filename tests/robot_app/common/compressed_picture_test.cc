#include "robot_app/common/compressed_picture.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <random>

namespace coppice::robot {
namespace {

using testing::HasSubstr;

Picture Gradient(int width, int height) {
  Picture picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::uint8_t* const pixel = &picture.rgb[3 * (static_cast<std::size_t>(y) * width + x)];
      pixel[0] = static_cast<std::uint8_t>(x);
      pixel[1] = static_cast<std::uint8_t>(2 * y);
      pixel[2] = 90;
    }
  }
  return picture;
}

DepthPicture Steps(int width, int height) {
  DepthPicture picture(width, height);
  for (std::size_t i = 0; i < picture.millimetres.size(); ++i) {
    picture.millimetres[i] = static_cast<std::uint16_t>(i * 37);
  }
  return picture;
}

TEST(CompressedPicture, AColourPictureComesBackNearlyTheSame) {
  const Picture sent = Gradient(200, 100);
  const Expected<Picture> read = DecodeJpeg(EncodeJpeg(sent, 95));
  ASSERT_TRUE(read) << read.problem();
  ASSERT_EQ(read->width, 200);
  ASSERT_EQ(read->height, 100);
  for (int x = 8; x < 192; x += 8) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(read->at(x, 50)[k], sent.at(x, 50)[k], 6) << x;
  }
}

TEST(CompressedPicture, IsSmallerWithLessQuality) {
  const Picture picture = Gradient(64, 64);
  EXPECT_LT(EncodeJpeg(picture, 20).size(), EncodeJpeg(picture, 90).size());
}

TEST(CompressedPicture, DepthComesBackToTheMillimetre) {
  const DepthPicture sent = Steps(123, 45);
  const Expected<DepthPicture> read = DecodeDepth(EncodeDepth(sent));
  ASSERT_TRUE(read) << read.problem();
  EXPECT_EQ(read->width, 123);
  EXPECT_EQ(read->height, 45);
  EXPECT_EQ(read->millimetres, sent.millimetres);
}

TEST(CompressedPicture, ThePngBeginsAfterTwelveBytesAsItsReadersExpect) {
  const std::vector<std::uint8_t> bytes = EncodeDepth(Steps(8, 8));
  ASSERT_GT(bytes.size(), 20u);
  EXPECT_EQ(std::string(bytes.begin() + 13, bytes.begin() + 16), "PNG");
}

TEST(CompressedPicture, NoPixelsGiveNoBytes) {
  EXPECT_TRUE(EncodeJpeg({}).empty());
  EXPECT_TRUE(EncodeDepth({}).empty());
}

TEST(CompressedPicture, APictureOfAnotherKindIsAProblem) {
  const std::vector<std::uint8_t> jpeg = EncodeJpeg(Gradient(8, 8));
  const std::vector<std::uint8_t> depth = EncodeDepth(Steps(8, 8));
  EXPECT_THAT(DecodeJpeg(depth).problem(), HasSubstr("no JPEG"));
  EXPECT_THAT(DecodeDepth(jpeg).problem(), HasSubstr("no PNG"));
  EXPECT_FALSE(DecodeJpeg({}));
  EXPECT_THAT(DecodeDepth({}).problem(), HasSubstr("ends early"));
}

TEST(CompressedPicture, ATruncatedPictureIsAProblem) {
  std::vector<std::uint8_t> jpeg = EncodeJpeg(Gradient(250, 120));
  std::vector<std::uint8_t> depth = EncodeDepth(Steps(64, 64));
  jpeg.resize(jpeg.size() - 40);
  depth.resize(depth.size() - 40);
  EXPECT_THAT(DecodeJpeg(jpeg).problem(), HasSubstr("damaged JPEG"));
  EXPECT_THAT(DecodeDepth(depth).problem(), HasSubstr("damaged PNG"));
}

void WriteBigEndian(std::uint32_t number, std::uint8_t* to) {
  for (int i = 0; i < 4; ++i) to[i] = static_cast<std::uint8_t>(number >> (24 - 8 * i));
}

TEST(CompressedPicture, APngThatClaimsBillionsOfPixelsIsRefusedBeforeTheyAreAllocated) {
  std::vector<std::uint8_t> depth = EncodeDepth(Steps(8, 8));
  std::uint8_t* const header = &depth[12 + 12];  // "IHDR", width, height, five more, checksum
  ASSERT_EQ(std::string(header, header + 4), "IHDR");
  WriteBigEndian(100000, header + 4);
  WriteBigEndian(100000, header + 8);
  WriteBigEndian(static_cast<std::uint32_t>(crc32(0, header, 17)), header + 17);
  EXPECT_THAT(DecodeDepth(depth).problem(), HasSubstr("100000 x 100000 pixels, expected at most"));
}

TEST(CompressedPicture, AJpegThatClaimsBillionsOfPixelsIsRefusedBeforeTheyAreAllocated) {
  std::vector<std::uint8_t> jpeg = EncodeJpeg(Gradient(8, 8));
  const std::array<std::uint8_t, 2> frame = {0xff, 0xc0};  // then length, depth, height, width
  const auto found = std::search(jpeg.begin(), jpeg.end(), frame.begin(), frame.end());
  ASSERT_NE(found, jpeg.end());
  std::fill(found + 5, found + 9, std::uint8_t{0xf0});
  EXPECT_THAT(DecodeJpeg(jpeg).problem(), HasSubstr("61680 x 61680 pixels, expected at most"));
}

// Whatever bytes come, the answer is a picture or a problem.
// A progressive JPEG of one grey block, and so many scans that say nothing about it.
std::vector<std::uint8_t> JpegOfScans(int scans) {
  std::vector<std::uint8_t> bytes = {0xFF, 0xD8, 0xFF, 0xDB, 0, 67, 0};
  const auto add = [&bytes](std::initializer_list<std::uint8_t> more, std::size_t zeros = 0) {
    bytes.insert(bytes.end(), more);
    bytes.insert(bytes.end(), zeros, 0);
  };
  bytes.insert(bytes.end(), 64, 1);                        // how it is quantized
  add({0xFF, 0xC2, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0});  // 8 x 8
  for (const int table : {0, 0x10}) {                      // codes of one bit each
    add({0xFF, 0xC4, 0, 20, static_cast<std::uint8_t>(table), 1}, 15);
    add({static_cast<std::uint8_t>(table == 0 ? 0 : 0xE0)});  // E0: nothing for 16384 blocks
  }
  add({0xFF, 0xDA, 0, 8, 1, 1, 0, 0, 0, 0, 0x7F});
  for (int i = 1; i < scans; ++i) add({0xFF, 0xDA, 0, 8, 1, 1, 0, 1, 63, 0, 0, 1});
  add({0xFF, 0xD9});
  return bytes;
}

// Of a large picture each costs milliseconds: 100 KB of them were 8 s.
TEST(CompressedPicture, AJpegOfMoreScansThanAnyCameraMakesIsRefused) {
  const Expected<Picture> few = DecodeJpeg(JpegOfScans(10));
  EXPECT_TRUE(few) << few.problem();
  EXPECT_THAT(DecodeJpeg(JpegOfScans(600)).problem(), HasSubstr("more than 500 scans"));
}

TEST(CompressedPicture, DamagedBytesNeverDoHarm) {
  std::mt19937 random(1);
  const std::vector<std::uint8_t> jpeg = EncodeJpeg(Gradient(40, 30));
  const std::vector<std::uint8_t> depth = EncodeDepth(Steps(40, 30));
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::vector<std::uint8_t> a = jpeg;
    std::vector<std::uint8_t> b = depth;
    for (int k = 0; k < 3; ++k) {
      a[random() % a.size()] = static_cast<std::uint8_t>(random());
      b[random() % b.size()] = static_cast<std::uint8_t>(random());
    }
    refused += !DecodeJpeg(a).ok() + !DecodeDepth(b).ok();
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace coppice::robot
