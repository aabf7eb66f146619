#include "editor/render/image.h"

#include <gtest/gtest.h>
#include <png.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Image, IsThereAsAWholePngFile) {
  const TemporaryFile place("x", "");
  Image image = MakeImage(3, 2, 0xFF102030);
  image.pixels[4] = 0xFF0000FF;
  const std::string path = place.folder() + "/p.png";
  ASSERT_EQ(WritePng(image, path).problem(), "");
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));

  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_file(&png, path.c_str()));
  png.format = PNG_FORMAT_RGBA;
  std::vector<std::uint32_t> pixels(6);
  ASSERT_EQ(png.width, 3U);
  ASSERT_TRUE(png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr));
  EXPECT_EQ(pixels, image.pixels);
}

TEST(Image, SaysWhyItCannotBeWritten) {
  EXPECT_NE(WritePng(MakeImage(1, 1, 0), "/nowhere/p.png").problem().find("/nowhere"),
            std::string::npos);
}

TEST(Image, HasAnotherHashWhenOnePixelDiffers) {
  Image image = MakeImage(10, 10, 7);
  const std::uint64_t before = HashOf(image);
  image.pixels[55] ^= 1;
  EXPECT_NE(HashOf(image), before);
}

}  // namespace
}  // namespace coppice::editor
