#include "editor/commands/log_commands.h"

#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

class LogCommandsTest : public testing::Test {
 protected:
  EditorState& state() { return driver_.editor.state(); }
  void Answer(const std::string& text) {
    driver_.Frames();
    driver_.Press('A', kCtrl);
    driver_.Type(text);
    driver_.Press(kKeyEnter);
    driver_.Frames();
  }

  Driver driver_;
};

TEST_F(LogCommandsTest, ALogPointIsAskedForOnceAndThenChanged) {
  AddExecuted(driver_, "robot:1", 5);
  driver_.Click("outline/1.1.1");
  driver_.Frames();
  state().commands.Run("run.log_point");
  Answer("a #x");
  EXPECT_EQ(state().popup.kind, Popup::kPrompt) << "a mistake can be corrected";
  EXPECT_FALSE(state().popup.error.empty());
  Answer("a");
  ASSERT_EQ(state().workspace.log_points.all().size(), 1U);
  EXPECT_EQ(state().workspace.log_points.all()[0].run, "robot:1");
  state().commands.Run("run.log_point");
  driver_.Frames();
  EXPECT_EQ(state().popup.text, "a") << "there is one at this node";
  Answer("b");
  ASSERT_EQ(state().workspace.log_points.all().size(), 1U);
  EXPECT_EQ(state().workspace.log_points.all()[0].text, "b");
}

TEST_F(LogCommandsTest, OfARecordItIsForEveryRun) {
  AddExecuted(driver_, "night.coppice", 5, false);
  driver_.Click("outline/1.1.1");
  driver_.Frames();
  state().commands.Run("run.log_point");
  Answer("a");
  EXPECT_EQ(state().workspace.log_points.all()[0].run, "");
}

TEST_F(LogCommandsTest, ALaneIsPinnedByItsNode) {
  AddExecuted(driver_, "robot:1", 5);
  driver_.view().Select(kNoSceneNode);
  state().commands.Run("run.pin");
  EXPECT_TRUE(state().notice.is_refusal) << "which one?";
  driver_.Click("outline/1.1.1");
  driver_.Frames();
  state().commands.Run("run.pin");
  EXPECT_EQ(state().workspace.pins.Of("robot:1").size(), 1U);
  state().commands.Run("run.pin");
  EXPECT_TRUE(state().workspace.pins.Of("robot:1").empty());
}

}  // namespace
}  // namespace coppice::editor
