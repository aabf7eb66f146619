#include "editor/shell/editor.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <utility>

#include "editor/theme/fonts.h"
#include "editor/theme/imgui_context.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Editor, BuildsAFrameWithNothingOpen) {
  Driver driver;
  ASSERT_EQ(driver.editor.error(), "");
  driver.Frames(4);
  for (const char* path : {"menu/file", "bar/connect", "project", "outline", "inspector",
                           "blackboard", "xml", "problems", "start/open", "bar/palette"}) {
    EXPECT_TRUE(driver.Has(path)) << path;
  }
}

// Of any channel of any pixel; the texture's size is in the rounding of what is read from it.
int LargestDifference(const Image& a, const Image& b) {
  int largest = a.pixels.size() == b.pixels.size() ? 0 : 255;
  for (std::size_t i = 0; largest < 255 && i < a.pixels.size(); ++i) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
      const int one = static_cast<int>(a.pixels[i] >> shift & 0xFF);
      const int other = static_cast<int>(b.pixels[i] >> shift & 0xFF);
      largest = std::max(largest, std::abs(one - other));
    }
  }
  return largest;
}

// What a window bakes first, against fonts that had all characters of the file from the beginning.
class FirstFrame : public testing::Test {
 protected:
  static Image Draw(const TemporaryFile& file, const CharacterSet& characters, int frames = 1) {
    EditorOptions options;
    options.fonts = std::make_shared<const Fonts>(1, characters);
    const std::shared_ptr<const Fonts> given = options.fonts;
    Editor editor(std::move(options));
    EXPECT_TRUE(editor.Open(file.path()));
    InputEvents input;
    input.dt = 0.2F;
    for (int frame = 0; frame < frames; ++frame) editor.Frame(input);
    baked_more_ = ImGuiFonts(editor) != given->Pick(Face::kSans, 13)->ContainerAtlas;
    return editor.Picture();
  }
  static const ImFontAtlas* ImGuiFonts(const Editor& editor) {
    const WithContext current(editor.context());
    return ImGui::GetIO().Fonts;
  }
  static constexpr int kTillAtRest = 5;
  static inline bool baked_more_ = false;
};

TEST_F(FirstFrame, OfUsualCharactersLooksTheSameWithoutAllOfThem) {
  const TemporaryFile file("first.xml", kSmallFile);
  const Image all = Draw(file, Alphabets());
  EXPECT_LE(LargestDifference(Draw(file, {}), all), 2);
  EXPECT_FALSE(baked_more_);
}

TEST_F(FirstFrame, ShowsWhatIsNotUsual) {
  for (const char* name : {"T\xC3\xBCr", "T&#252;r", "\xE6\x88\xBF", "\xD0\x96"}) {
    std::string text = kSmallFile;
    text.replace(text.find("MainTree"), 8, name);
    if (const auto again = text.find("MainTree"); again != std::string::npos) {
      text.replace(again, 8, name);
    }
    const TemporaryFile file("first.xml", text);
    CharacterSet characters = UnusualCharacters(name);
    characters.insert(0xFC);
    const Image all = Draw(file, characters, kTillAtRest);
    EXPECT_LE(LargestDifference(Draw(file, {}, kTillAtRest), all), 2) << name;
    EXPECT_TRUE(baked_more_) << name;
  }
}

TEST_F(FirstFrame, BakesOnceForWhatNoFontHas) {
  std::string text = kSmallFile;
  text.replace(text.find("round"), 5, "\xE0\xBC\x80");  // Tibetan
  const TemporaryFile file("first.xml", text);
  const Image asked = Draw(file, {0x0F00}, kTillAtRest);
  EXPECT_FALSE(baked_more_);
  EXPECT_LE(LargestDifference(Draw(file, {}, kTillAtRest), asked), 2);
}

TEST(Editor, WaitsForNoPipeInThePlaceOfItsOwnFiles) {
  const TemporaryFile file("small.xml", kSmallFile);
  const std::string state = file.folder() + "/state";
  std::filesystem::create_directory(state);
  EditorOptions options;
  options.keys_file = state + "/keys";
  options.marks_file = state + "/marks";
  options.recent_file = state + "/recent";
  options.backup_folder = state;
  for (const char* name : {"keys", "marks", "recent", "1.1.unsaved", "history-1"}) {
    ASSERT_EQ(mkfifo((state + "/" + name).c_str(), 0600), 0);
  }
  Driver driver(std::move(options));
  EXPECT_TRUE(driver.editor.Open(file.path()));
  driver.Frames(4);
}

TEST(Editor, ReadsNoKeysWithoutEnd) {
  const TemporaryFile keys("keys", std::string(2 << 20, '\n') + "undo = F2\n");
  EditorOptions options;
  options.keys_file = keys.path();
  Driver driver(std::move(options));
  const Diagnostics& problems = driver.editor.state().key_settings.problems;
  ASSERT_EQ(problems.all().size(), 1u);
  EXPECT_NE(problems.all()[0].message.find("longer than"), std::string::npos);
}

TEST(Editor, SurvivesTinyAndHugeWindows) {
  const TemporaryFile file("small.xml", kSmallFile);
  for (const Point size : {Point{1, 1}, Point{200, 100}, Point{5000, 3000}}) {
    Driver driver;
    driver.editor.Open(file.path());
    driver.input.width = size.x;
    driver.input.height = size.y;
    driver.Frames(4);
    EXPECT_EQ(driver.editor.Picture().width, static_cast<int>(size.x));
  }
}

TEST(Editor, ShowsWhatIsWrongWithABrokenFileAndItsText) {
  const TemporaryFile file("broken.xml", "<root>\n<BehaviorTree ID=\"A\">\n</root>\n");
  Driver driver;
  EXPECT_FALSE(driver.editor.Open(file.path()));
  driver.Frames(4);
  EXPECT_TRUE(driver.Has("problems/0"));
  EXPECT_TRUE(driver.Has("xml/2"));
  EXPECT_EQ(driver.editor.state().workspace.view(), nullptr);
  driver.Picture("broken");
}

TEST(Editor, AcceptsLeavesThatItDoesNotKnow) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  EXPECT_TRUE(driver.editor.Open(file.path()));
  for (const Diagnostic& problem : driver.editor.state().workspace.files()[0].problems) {
    EXPECT_NE(problem.severity, Severity::kError) << ToString(problem);
  }
}

TEST(Editor, IsAtRestWhenNothingMoves) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames(5);
  EXPECT_GT(driver.editor.NextFrameIn(), 0.1) << "until the next look at the disk";
  driver.Click("canvas/MainTree/1.2/toggle");
  EXPECT_EQ(driver.editor.NextFrameIn(), 0) << "the boxes are on their way";
  driver.Frames(20);
  EXPECT_GT(driver.editor.NextFrameIn(), 0.1);
  Driver empty;
  empty.Frames(5);
  EXPECT_EQ(empty.editor.NextFrameIn(), std::numeric_limits<double>::infinity());
}

TEST(Editor, MovesAtAModestRateWhileLive) {
  Driver driver;
  driver.AddRobot("robot:1", kLiveTree);
  driver.Frames(10);
  EXPECT_GT(driver.editor.NextFrameIn(), 0.02);
  EXPECT_LT(driver.editor.NextFrameIn(), 0.2);
}

TEST(Editor, LosesNoTapOfAKeyInASlowFrame) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.Click("canvas/MainTree/1.2");
  for (int i = 0; i < 5; ++i) {  // five taps before the next frame
    driver.input.events.push_back(KeyEvent{'C', true});
    driver.input.events.push_back(KeyEvent{'C', false});
  }
  driver.Frames(20);
  EXPECT_TRUE(driver.view().IsCollapsed(driver.view().selected())) << "an odd number of taps";
}

TEST(Editor, RefusesAnEndpointThatIsNone) {
  Driver driver;
  EXPECT_FALSE(driver.editor.Connect("no where:x"));
  EXPECT_FALSE(driver.editor.Connect("host:99999"));
  EXPECT_FALSE(driver.editor.Connect(":1667"));
  EXPECT_TRUE(driver.editor.state().workspace.runs().empty());
}

TEST(Editor, RemembersRecentFiles) {
  const TemporaryFile file("small.xml", kSmallFile);
  EditorOptions options;
  options.recent_file = file.folder() + "/deep/recent";
  {
    Driver driver(options);
    driver.editor.Open(file.path());
  }
  Driver driver(options);
  ASSERT_EQ(driver.editor.state().recent.files.size(), 1U);
  EXPECT_EQ(driver.editor.state().recent.files[0], file.path());
  driver.Frames();
  driver.Click("menu/file");
  driver.Click("menu/file.recent");
  ASSERT_TRUE(driver.Click("menu/recent/0"));
  EXPECT_NE(driver.editor.state().workspace.view(), nullptr);
}

TEST(Editor, ReloadsAFileAndKeepsTheSelection) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.Click("canvas/MainTree/1.1.2");
  std::string text = kSmallFile;
  text.replace(text.find(R"(name="round")"), 12, R"(name="other")");
  file.Write(text);
  driver.Press('R', kCtrl);
  EXPECT_EQ(driver.view().scene()->nodes[0].name, "other");
  EXPECT_EQ(driver.Selected(), "1.1.2");
}

}  // namespace
}  // namespace coppice::editor
