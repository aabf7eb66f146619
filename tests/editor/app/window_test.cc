#include <gtest/gtest.h>
#include <png.h>

#include "tests/editor/app/program.h"
#include "tests/editor/driver.h"
#include "tests/support/folders.h"

namespace coppice::editor {
namespace {

constexpr std::chrono::seconds kLongest{18};

std::string FreeDisplay() {
  int number = 90 + ::getpid() % 400;
  while (std::filesystem::exists("/tmp/.X" + std::to_string(number) + "-lock")) ++number;
  return ":" + std::to_string(number);
}

// Empty if it is not there yet, or is none.
Image ReadPng(const std::string& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  Image image;
  if (!png_image_begin_read_from_file(&png, path.c_str())) return image;
  png.format = PNG_FORMAT_RGBA;
  image = MakeImage(static_cast<int>(png.width), static_cast<int>(png.height), 0);
  if (!png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr)) image = {};
  return image;
}

int CountLike(const Image& image, Color color) {
  return static_cast<int>(std::count(image.pixels.begin(), image.pixels.end(), color));
}

// The real window: an X server in memory, keys from xdotool, pictures through glReadPixels.
TEST(Window, ShowsTheTreeAndObeysKeys) {
  const TemporaryFile file("small.xml", kSmallFile);
  const std::string display = FreeDisplay();
  const std::string x_errors = file.folder() + "/x";
  StartedProgram server({"Xvfb", display, "-screen", "0", "1024x768x24", "-nolisten", "tcp"}, {},
                        x_errors);
  ASSERT_TRUE(WaitFor(
      [&] { return std::filesystem::exists("/tmp/.X11-unix/X" + display.substr(1)); }, kLongest))
      << ReadFile(x_errors);

  const std::string picture = file.folder() + "/window.png";
  const std::string errors = file.folder() + "/errors";
  // What the driver of the graphics card leaks has no name to leave out: it is unloaded by then.
  const std::vector<std::string> environment = {
      "DISPLAY=" + display, "XDG_CONFIG_HOME=" + file.folder(), "ASAN_OPTIONS=detect_leaks=0"};
  StartedProgram editor({BinaryFolder() + "/bin/coppice-edit", file.path(), "--size", "1000x700",
                         "--picture", picture, "--every", "0.1"},
                        environment, errors);
  const Palette& colors = GetPalette(PaletteName::kDark);
  ASSERT_TRUE(WaitFor([&] { return CountLike(ReadPng(picture), colors.action) > 300; }, kLongest))
      << ReadFile(errors);
  const Image first = ReadPng(picture);
  EXPECT_EQ(first.width, 1000);
  EXPECT_GT(CountLike(first, colors.control), 300);

  // Down selects the root: its frame appears in the accent colour.
  const int before = CountLike(first, colors.accent);
  StartedProgram key({"xdotool", "key", "Down"}, environment, x_errors);
  EXPECT_EQ(key.Wait(kLongest), 0);
  EXPECT_TRUE(
      WaitFor([&] { return CountLike(ReadPng(picture), colors.accent) > before + 50; }, kLongest));
  if (const char* folder = std::getenv("COPPICE_PICTURES")) {
    std::filesystem::copy_file(picture, std::string(folder) + "/window.png",
                               std::filesystem::copy_options::overwrite_existing);
  }

  StartedProgram quit({"xdotool", "key", "ctrl+q"}, environment, x_errors);
  EXPECT_EQ(quit.Wait(kLongest), 0);
  EXPECT_EQ(editor.Wait(kLongest), 0) << ReadFile(errors);
  server.Signal(SIGTERM);
  EXPECT_EQ(server.Wait(kLongest), 0);
}

}  // namespace
}  // namespace coppice::editor
