#include "editor/commands/run_commands.h"

#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

using Kind = LiveCommand::Kind;

class RunCommandsTest : public testing::Test {
 protected:
  EditorState& state() { return driver_.editor.state(); }
  Driver driver_;
};

TEST_F(RunCommandsTest, PauseStepAndContinueTheRobotByKey) {
  ExecutedSource* robot = AddExecuted(driver_, "robot:1", 5);
  driver_.Press(kKeySpace, kShift);
  EXPECT_EQ(robot->commands.back().kind, Kind::kPause);
  robot->StopBefore(NodeIndex{1});
  driver_.Frames();
  driver_.Press(kKeyF1 + 9);
  EXPECT_EQ(robot->commands.back().kind, Kind::kStepTick);
  driver_.Press(kKeyF1 + 9, kShift);
  EXPECT_EQ(robot->commands.back().kind, Kind::kStepNode);
  driver_.Press(kKeySpace, kShift);
  EXPECT_EQ(robot->commands.back().kind, Kind::kContinue);
}

TEST_F(RunCommandsTest, SpaceAloneDoesNotStopARobotButSaysWhatDoes) {
  ExecutedSource* robot = AddExecuted(driver_, "robot:1", 5);
  driver_.Press(kKeySpace);
  EXPECT_TRUE(robot->commands.empty());
  EXPECT_EQ(state().notice.text, "Shift+Space pauses the robot");
}

TEST_F(RunCommandsTest, AFaultIsForcedShownEverywhereAndClearedByOneClick) {
  const TemporaryFile file("small.xml", kSmallFile);
  ExecutedSource* robot = AddExecuted(driver_, "robot:1", 5);
  ASSERT_TRUE(driver_.Click("canvas/Main/1.1.1"));
  state().commands.Run("run.force_failure");
  driver_.Frames();
  ASSERT_EQ(robot->commands.size(), 1U);
  EXPECT_EQ(robot->commands[0].hook.path, "IsDoorOpen");
  EXPECT_EQ(robot->commands[0].hook.status, Status::kFailure);
  driver_.Picture("fault");
  driver_.editor.Open(file.path());
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("strip/faults")) << "also while a file is edited";
  ASSERT_TRUE(driver_.Click("strip/clear_faults"));
  EXPECT_FALSE(driver_.Has("strip/faults"));
  EXPECT_EQ(robot->commands.back().kind, Kind::kRemoveHook);
}

TEST_F(RunCommandsTest, ABreakpointOfAFileIsForEveryRobotToCome) {
  const TemporaryFile file("door.xml",
                           R"(<root BTCPP_format="4">)" + std::string(kDoorTrees) + "</root>");
  driver_.editor.Open(file.path());
  driver_.Frames();
  ASSERT_TRUE(driver_.Click("canvas/Main/1.2.1"));
  EXPECT_EQ(SelectedRunPath(state()), "pass/Drive");
  driver_.Press(kKeyF1 + 8);
  ASSERT_EQ(state().workspace.hooks.all().size(), 1U);
  ExecutedSource* robot = AddExecuted(driver_, "robot:1", 1);
  driver_.Frames();
  ASSERT_EQ(robot->commands.size(), 1U);
  EXPECT_EQ(robot->commands[0].hook.path, "pass/Drive");
}

TEST_F(RunCommandsTest, WritesAKey) {
  ExecutedSource* robot = AddExecuted(driver_, "robot:1", 5);
  state().blackboard.shown_key = "blackboard/pass/steps";
  state().commands.Run("blackboard.write");
  driver_.Frames();
  driver_.Type("42");
  driver_.Press(kKeyEnter);
  ASSERT_FALSE(robot->commands.empty());
  EXPECT_EQ(robot->commands.back().kind, Kind::kWrite);
  EXPECT_EQ(robot->commands.back().scope, "pass");
  EXPECT_EQ(robot->commands.back().key, "steps");
  EXPECT_EQ(robot->commands.back().value, "42");
}

TEST_F(RunCommandsTest, SavesWhatWasReceivedAndOpensItAgain) {
  AddExecuted(driver_, "robot:1", 25);
  const TemporaryFile folder("x", "");
  const std::string path = folder.folder() + "/run.coppice";
  state().commands.Run("run.save");
  driver_.Frames();
  driver_.Press('A', kCtrl);
  driver_.Type(path);
  driver_.Press(kKeyEnter);
  ASSERT_TRUE(driver_.editor.Open(path));
  driver_.Frames(10);
  EXPECT_EQ(state().workspace.run()->name(), path);
  EXPECT_EQ(state().workspace.run()->run().size(), 25U);
}

TEST_F(RunCommandsTest, ARecordIsOfferedTheNameOfItsTreeThatIsFree) {
  const TemporaryFile file("a.coppice", "");
  AddExecuted(driver_, file.path(), 3, false);
  const auto offered = [this] {
    state().commands.Run("run.save");
    driver_.Frames();
    std::string name = std::filesystem::path(state().popup.text).filename();
    driver_.Press(kKeyEscape);
    return name;
  };
  const std::string first = offered();
  EXPECT_EQ(first.substr(0, 4), "Main");
  ASSERT_EQ(first.substr(first.size() - 8), ".coppice");
  WriteFile(file.folder() + "/" + first, "precious");
  EXPECT_EQ(offered(), first.substr(0, first.size() - 8) + "-2.coppice");
}

TEST_F(RunCommandsTest, ARecordIsNeverOverwritten) {
  AddExecuted(driver_, "robot:1", 3);
  const TemporaryFile there("run.coppice", "precious");
  state().commands.Run("run.save");
  driver_.Frames();
  driver_.Press('A', kCtrl);
  driver_.Type(there.path());
  driver_.Press(kKeyEnter);
  EXPECT_NE(state().popup.error.find("never overwritten"), std::string::npos);
  EXPECT_EQ(ReadFile(there.path()), "precious");
}

TEST_F(RunCommandsTest, SavesTheTreeOfTheRobotAndOpensItToBeEdited) {
  AddExecuted(driver_, "robot:1", 3);
  const TemporaryFile folder("x", "");
  const std::string path = folder.folder() + "/copy.xml";
  driver_.Press('S', kCtrl | kAlt | kShift);
  driver_.Press('A', kCtrl);
  driver_.Type(path);
  driver_.Press(kKeyEnter);
  driver_.Frames(4);
  ASSERT_NE(state().workspace.file(), nullptr);
  EXPECT_EQ(state().workspace.file()->path, path);
  EXPECT_EQ(state().workspace.view()->scene()->tree_id, "Main");
}

TEST_F(RunCommandsTest, TheArrowsMoveThePlayheadAndWithCtrlTheSelection) {
  AddExecuted(driver_, "robot:1", 10);
  ASSERT_TRUE(driver_.Click("canvas/Main/1.1"));
  driver_.Press(kKeyLeft);
  EXPECT_EQ(state().workspace.run()->playhead().tick(), 8U);
  EXPECT_EQ(driver_.Selected(), "1.1");
  driver_.Press(kKeyRight, kCtrl);
  EXPECT_EQ(driver_.Selected(), "1.2");
}

}  // namespace
}  // namespace coppice::editor
