#include "editor/shell/editor.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <limits>

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
