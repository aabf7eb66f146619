#include <gtest/gtest.h>
#include <png.h>

#include <memory>

#include "editor/files/unsaved_work.h"
#include "tests/editor/app/close_window.h"
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
class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(WaitFor(
        [&] { return std::filesystem::exists("/tmp/.X11-unix/X" + display_.substr(1)); }, kLongest))
        << ReadFile(x_errors_);
    editor_ = std::make_unique<StartedProgram>(
        std::vector<std::string>{BinaryFolder() + "/bin/coppice-edit", file_.path(), "--size",
                                 "1000x700", "--picture", picture_, "--every", "0.1"},
        environment_, errors_);
    ASSERT_TRUE(
        WaitFor([&] { return CountLike(ReadPng(picture_), colors_.action) > 300; }, kLongest))
        << ReadFile(errors_);
  }

  void Press(const std::string& key) {
    EXPECT_EQ(StartedProgram({"xdotool", "key", key}, environment_, x_errors_).Wait(kLongest), 0);
  }

  // True when there are more pixels of that colour than before.
  bool ShowsMore(Color color, int than) {
    return WaitFor([&] { return CountLike(ReadPng(picture_), color) > than; }, kLongest);
  }

  // Disables the root.
  void ChangeTheTree() {
    const int before = CountLike(ReadPng(picture_), colors_.accent);
    Press("Down");
    ASSERT_TRUE(ShowsMore(colors_.accent, before + 50));
    Press("d");
    ASSERT_TRUE(WaitFor([&] { return Title().rfind("* ", 0) == 0; }, kLongest)) << Title();
  }

  std::string Title() {
    const std::string output = file_.folder() + "/title";
    StartedProgram(
        {"sh", "-c", "xdotool search --onlyvisible --name Coppice getwindowname > " + output},
        environment_, x_errors_)
        .Wait(kLongest);
    return ReadFile(output);
  }

  // What the next editor would offer.
  std::string Left() const {
    UnsavedWork work(file_.folder() + "/coppice/backup");
    work.Look(OpenProject());
    return work.left().empty() ? "" : UnsavedWork::TextOf(work.left().front()).value_or("");
  }

  const TemporaryFile file_{"small.xml", kSmallFile};
  const std::string display_ = FreeDisplay();
  const std::string x_errors_ = file_.folder() + "/x";
  const std::string errors_ = file_.folder() + "/errors";
  const std::string picture_ = file_.folder() + "/window.png";
  const Palette& colors_ = GetPalette(PaletteName::kDark);
  // What the driver of the graphics card leaks has no name to leave out: it is unloaded by then.
  const std::vector<std::string> environment_ = {
      "DISPLAY=" + display_, "XDG_CONFIG_HOME=" + file_.folder(),
      "XDG_STATE_HOME=" + file_.folder(), "ASAN_OPTIONS=detect_leaks=0"};
  StartedProgram server_{
      {"Xvfb", display_, "-screen", "0", "1024x768x24", "-nolisten", "tcp"}, {}, x_errors_};
  std::unique_ptr<StartedProgram> editor_;
};

TEST_F(WindowTest, ShowsTheTreeAndObeysKeys) {
  const Image first = ReadPng(picture_);
  EXPECT_EQ(first.width, 1000);
  EXPECT_GT(CountLike(first, colors_.control), 300);
  // Down selects the root: its frame appears in the accent colour.
  const int before = CountLike(first, colors_.accent);
  Press("Down");
  EXPECT_TRUE(ShowsMore(colors_.accent, before + 50));
  if (const char* folder = std::getenv("COPPICE_PICTURES")) {
    std::filesystem::copy_file(picture_, std::string(folder) + "/window.png",
                               std::filesystem::copy_options::overwrite_existing);
  }
  Press("ctrl+q");
  EXPECT_EQ(editor_->Wait(kLongest), 0) << ReadFile(errors_);
  server_.Signal(SIGTERM);
  EXPECT_EQ(server_.Wait(kLongest), 0);
}

TEST_F(WindowTest, ClosingItAsksWhatBecomesOfUnsavedWork) {
  ChangeTheTree();
  const int before = CountLike(ReadPng(picture_), colors_.accent);
  ASSERT_TRUE(CloseWindow(display_, "* small.xml - Coppice"));
  ASSERT_TRUE(ShowsMore(colors_.accent, before + 200)) << "the frame of the question";
  Press("Return");
  EXPECT_EQ(editor_->Wait(kLongest), 0) << ReadFile(errors_);
  EXPECT_NE(ReadFile(file_.path()), kSmallFile) << "saved";
  EXPECT_EQ(Left(), "");
}

TEST_F(WindowTest, LeavesUnsavedWorkWhenItIsTerminated) {
  ChangeTheTree();
  editor_->Signal(SIGTERM);
  EXPECT_EQ(editor_->Wait(kLongest), 0) << ReadFile(errors_);
  EXPECT_EQ(ReadFile(file_.path()), kSmallFile);
  EXPECT_NE(Left().find("_skipIf"), std::string::npos);
}

TEST_F(WindowTest, LeavesUnsavedWorkWhenTheDisplayGoes) {
  ChangeTheTree();
  server_.Signal(SIGKILL);
  EXPECT_NE(editor_->Wait(kLongest), 0);
  EXPECT_NE(Left().find("_skipIf"), std::string::npos) << ReadFile(errors_);
}

}  // namespace
}  // namespace coppice::editor
