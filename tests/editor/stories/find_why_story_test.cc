#include <gtest/gtest.h>

#include <fstream>

#include "bt_core/analysis/formats/write_record.h"
#include "editor/render/image.h"
#include "tests/editor/executed_source.h"
#include "tests/editor/reference_picture.h"

namespace coppice::editor {
namespace {

// A robot that drove for a while and then stood still. Why?
class FindWhyStory : public testing::Test {
 protected:
  // Its record, as it lies on the disk.
  FindWhyStory() {
    ExecutedTree tree(kDoorTrees);
    coppice::editor::Run run;
    Follow follow(tree.executor, run);
    tree.results["drive"] = Status::kRunning;
    for (int i = 0; i < 40; ++i) tree.Tick();
    tree.results["drive"] = Status::kFailure;
    tree.Tick();
    tree.results["open"] = tree.results["open it"] = Status::kFailure;
    for (int i = 0; i < 15; ++i) tree.Tick();
    path_ = folder_.folder() + "/night.coppice";
    std::ofstream(path_, std::ios::binary) << ToRecord(run.recording());
  }
  const TemporaryFile folder_{"x", ""};
  std::string path_;
};

TEST_F(FindWhyStory, FindsWhyTheRobotStoppedInThisRecord) {
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(path_));
  driver.Frames(10);
  RunView& run = *driver.editor.state().workspace.run();
  EXPECT_EQ(run.run().size(), 56U);
  // At the end it stands still: the mission fails in every tick.
  EXPECT_EQ(run.state().states[0].status, Status::kFailure);
  // Back to where that began, by the keyboard.
  driver.Press(kKeyUp);
  EXPECT_EQ(driver.Selected(), "1");
  driver.Press(kKeyLeft, kShift);
  EXPECT_EQ(run.playhead().tick(), 40U);
  driver.Press('W');
  EXPECT_NE(driver.editor.state().run.why.change().find("Drive"), std::string::npos)
      << driver.editor.state().run.why.change();
  driver.Picture("editor_why");  // of docs/editor.md
  EXPECT_EQ(CompareWithReference(driver.editor.Picture(), "story_why_it_stopped"), "");
  // And why does it not drive again? The door.
  driver.Press(kKeyRight);
  driver.Press(kKeyDown);
  driver.Press(kKeyRight, kCtrl);
  driver.Press(kKeyDown);
  EXPECT_EQ(driver.Selected(), "1.2.1");
  EXPECT_NE(driver.editor.state().run.why.why_not().find("door"), std::string::npos)
      << driver.editor.state().run.why.why_not();
  driver.Picture("story_why_not");
}

TEST(BreakpointStory, WhyEndsWithTheNodeThatTheRobotStandsBefore) {
  Driver driver;
  ExecutedSource* const robot = AddExecuted(driver, "robot:1", 5);
  robot->StopBefore(NodeIndex{5});
  driver.Frames(4);
  driver.Press('W');
  ASSERT_TRUE(driver.Click("run/why/stands"));
  EXPECT_EQ(driver.Selected(), "1.2.1");
  EXPECT_EQ(driver.editor.state().run.why.stands(), "stopped before \"Drive\"");
  driver.Picture("story_stands");
}

}  // namespace
}  // namespace coppice::editor
