#include <gtest/gtest.h>

#include "tests/editor/app/program.h"
#include "tests/editor/driver.h"
#include "tests/support/folders.h"

namespace coppice::editor {
namespace {

constexpr std::chrono::seconds kLongest{15};
const std::string kProgram = BinaryFolder() + "/bin/coppice-edit";

class HeadlessTest : public testing::Test {
 protected:
  int Run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), kProgram);
    StartedProgram program(arguments, {"DISPLAY", "WAYLAND_DISPLAY"}, errors_);
    return program.Wait(kLongest);
  }
  TemporaryFile file_{"small.xml", kSmallFile};
  const std::string picture_ = file_.folder() + "/p.png";
  const std::string errors_ = file_.folder() + "/errors";
};

TEST_F(HeadlessTest, SavesTheSamePictureTwice) {
  ASSERT_EQ(Run({file_.path(), "--headless", "--picture", picture_, "--size", "800x600"}), 0);
  const std::string first = ReadFile(picture_);
  EXPECT_EQ(first.substr(1, 3), "PNG");
  ASSERT_EQ(Run({file_.path(), "--headless", "--picture", picture_, "--size", "800x600"}), 0);
  EXPECT_EQ(ReadFile(picture_), first);
}

TEST_F(HeadlessTest, ShowsABrokenFileInsteadOfFailing) {
  file_.Write("<root><Behavior");
  EXPECT_EQ(Run({file_.path(), "--headless", "--picture", picture_}), 0);
  EXPECT_TRUE(std::filesystem::exists(picture_));
}

TEST_F(HeadlessTest, SaysWhatIsWrongWithTheCommandLine) {
  EXPECT_EQ(Run({"--size", "huge"}), 2);
  EXPECT_NE(ReadFile(errors_).find("--size"), std::string::npos);
  EXPECT_EQ(Run({"--connect", "nowhere:99999", "--headless"}), 2);
  EXPECT_NE(ReadFile(errors_).find("nowhere"), std::string::npos);
}

TEST_F(HeadlessTest, SaysWhenThePictureCannotBeWritten) {
  EXPECT_EQ(Run({file_.path(), "--headless", "--picture", "/nowhere/p.png"}), 1);
  EXPECT_NE(ReadFile(errors_).find("/nowhere"), std::string::npos);
}

TEST_F(HeadlessTest, NamesTheWayOutWhenThereIsNoDisplay) {
  EXPECT_EQ(Run({file_.path()}), 2);
  EXPECT_NE(ReadFile(errors_).find("--headless"), std::string::npos);
}

TEST_F(HeadlessTest, RunsForTheGivenTimeAndEndsOnASignal) {
  EXPECT_EQ(Run({"--connect", "127.0.0.1:1", "--headless", "--for", "0.3"}), 0);
  StartedProgram program(
      {kProgram, "--connect", "127.0.0.1:1", "--headless", "--picture", picture_, "--every", "0.1"},
      {"DISPLAY"}, errors_);
  ASSERT_TRUE(WaitFor([&] { return std::filesystem::exists(picture_); }, kLongest));
  program.Signal(SIGTERM);
  EXPECT_EQ(program.Wait(kLongest), 0);
}

}  // namespace
}  // namespace coppice::editor
