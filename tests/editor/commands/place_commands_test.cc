#include "editor/commands/place_commands.h"

#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

class PlaceCommandsTest : public testing::Test {
 protected:
  EditorState& state() { return driver_.editor.state(); }
  RunView& run() { return *state().workspace.run(); }
  Driver driver_;
};

TEST_F(PlaceCommandsTest, ABookmarkIsSetNamedFoundAgainAndRemoved) {
  AddExecuted(driver_, "robot:1", 60);
  run().playhead().GoToTick(20);
  driver_.Press('M');
  EXPECT_TRUE(driver_.Has("timeline/bookmark/20"));
  driver_.Press('M', kShift);
  driver_.Type("here it turns");
  driver_.Press(kKeyEnter);
  run().playhead().GoToTick(40);
  driver_.Press('M');
  driver_.Press(kKeyLeft, kCtrl | kAlt);
  EXPECT_EQ(run().playhead().tick(), 20U);
  EXPECT_EQ(state().notice.text, "here it turns");
  driver_.Press(kKeyRight, kCtrl | kAlt);
  EXPECT_EQ(run().playhead().tick(), 40U);
  driver_.Press(kKeyRight, kCtrl | kAlt);
  EXPECT_TRUE(state().notice.is_refusal);
  driver_.Press('M', kCtrl);
  driver_.Type("turns");
  driver_.Press(kKeyEnter);
  EXPECT_EQ(run().playhead().tick(), 20U);
  driver_.Press('M');
  EXPECT_EQ(state().workspace.bookmarks.Of("robot:1").size(), 1U);
}

TEST_F(PlaceCommandsTest, RunToHereStopsTheRobotOnceAndLetsItGoOn) {
  ExecutedSource* robot = AddExecuted(driver_, "robot:1", 5);
  robot->StopBefore(NodeIndex{1});
  driver_.Frames();
  ASSERT_TRUE(driver_.Click("canvas/Main/1.2"));
  robot->commands.clear();
  driver_.Press(kKeyF1 + 9, kCtrl);
  ASSERT_EQ(robot->commands.size(), 2U);
  EXPECT_EQ(robot->commands[0].kind, LiveCommand::Kind::kAddHook) << "first the stop";
  EXPECT_EQ(robot->commands[0].hook.times, 1U);
  EXPECT_EQ(robot->commands[1].kind, LiveCommand::Kind::kContinue);
  ASSERT_EQ(state().workspace.hooks.all().size(), 1U);
  driver_.Frames();
  robot->StopBefore(NodeIndex{3});
  driver_.Frames();
  EXPECT_TRUE(state().workspace.hooks.all().empty()) << "it was for one time";
}

TEST_F(PlaceCommandsTest, RunToHereTicksASimulationUntilTheNodeIsTicked) {
  const TemporaryFile file(
      "wait.xml", R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>)"
                  R"(<Sleep msec="2000"/><AlwaysSuccess/></Sequence></BehaviorTree></root>)");
  driver_.editor.Open(file.path());
  driver_.Frames();
  driver_.Press(kKeyF1 + 4);
  driver_.Frames();
  ASSERT_TRUE(run().source().is_simulation());
  ASSERT_TRUE(driver_.Click("canvas/Main/1.2"));
  driver_.Press(kKeyF1 + 9, kCtrl);
  driver_.Frames();
  ASSERT_NE(state().simulator.get(), nullptr);
  EXPECT_GE(state().simulator.get()->now(), std::chrono::seconds(2));
  EXPECT_LT(state().simulator.get()->now(), std::chrono::milliseconds(2500));
}

TEST_F(PlaceCommandsTest, BreakpointsSurviveARestart) {
  const TemporaryFile folder("x", "");
  EditorOptions options;
  options.marks_file = folder.folder() + "/state/marks.json";
  {
    Driver driver(options);
    AddExecuted(driver, "robot:1", 5);
    ASSERT_TRUE(driver.Click("canvas/Main/1.2"));
    driver.Press(kKeyF1 + 8);
    driver.Frames();
  }
  Driver driver(options);
  driver.Frames();
  const auto& hooks = driver.editor.state().workspace.hooks.all();
  ASSERT_EQ(hooks.size(), 1U);
  EXPECT_EQ(hooks[0].robot, "robot:1");
  const ExecutedSource* robot = AddExecuted(driver, "robot:1", 1);
  driver.Frames();
  ASSERT_EQ(robot->commands.size(), 1U) << "the robot is told as soon as it is there";
}

}  // namespace
}  // namespace coppice::editor
