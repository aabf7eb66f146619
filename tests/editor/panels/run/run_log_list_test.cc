#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

class RunLogListTest : public testing::Test {
 protected:
  EditorState& state() { return driver_.editor.state(); }
  void Start() {
    robot_ = AddExecuted(driver_, "robot:1", 20);
    driver_.Click("outline/1.2.1");
    driver_.Frames();
  }
  void AddLogPoint(const std::string& text) {
    driver_.Press(kKeyF1 + 8, kCtrl | kShift);
    driver_.Frames();
    state().popup.text.clear();
    driver_.Type(text);
    driver_.Press(kKeyEnter);
    driver_.Frames();
  }

  Driver driver_;
  ExecutedSource* robot_ = nullptr;
};

TEST_F(RunLogListTest, ALogPointWritesLinesAndDoesNotStopTheRobot) {
  Start();
  AddLogPoint("at {steps}");
  ASSERT_EQ(state().workspace.log_points.all().size(), 1U) << driver_.Selected();
  EXPECT_EQ(state().run.tab, RunTab::kLog);
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("run/log/0"));
  robot_->tree.results["drive"] = Status::kSuccess;
  robot_->Ticks(3);
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("run/log/2"));
  EXPECT_TRUE(robot_->commands.empty()) << "the robot does not know";
  driver_.Picture("log_dark");
  state().screen.palette = PaletteName::kLight;
  driver_.Frames();
  driver_.Picture("log_light");
  EXPECT_TRUE(driver_.Click("run/log/0"));
  driver_.Frames();
  EXPECT_EQ(state().workspace.run()->playhead().tick(),
            state().run.logs["robot:1"].lines()[0].tick);
}

TEST_F(RunLogListTest, IsChangedSwitchedOffAndRemoved) {
  Start();
  AddLogPoint("one");
  const auto path = [this] {
    return "run/log/point/" + std::to_string(state().workspace.log_points.all()[0].number);
  };
  driver_.Frames();
  EXPECT_TRUE(driver_.Click(path() + "/text"));
  driver_.Frames();
  EXPECT_EQ(state().popup.text, "one");
  driver_.Press(kKeyEnd);
  driver_.Type(" #2");
  driver_.Press(kKeyEnter);
  driver_.Frames();
  EXPECT_EQ(ToString(state().workspace.log_points.all()[0]), "one #2");
  EXPECT_TRUE(driver_.Click(path() + "/on"));
  driver_.Frames();
  EXPECT_FALSE(state().workspace.log_points.all()[0].enabled);
  EXPECT_FALSE(driver_.Has("run/log/0"));
  EXPECT_TRUE(driver_.Click(path() + "/remove"));
  driver_.Frames();
  EXPECT_TRUE(state().workspace.log_points.all().empty());
}

TEST_F(RunLogListTest, WithoutASelectedNodeItSaysWhatIsMissing) {
  driver_.Press(kKeyF1 + 8, kCtrl | kShift);
  driver_.Frames();
  EXPECT_EQ(state().popup.kind, Popup::kNone);
  EXPECT_TRUE(state().notice.is_refusal);
}

}  // namespace
}  // namespace coppice::editor
