#include "editor/workspace/run_test_maker.h"

#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

class RunTestMakerTest : public testing::Test {
 protected:
  RunTestMakerTest()
      : file_("door.xml", R"(<root BTCPP_format="4" main_tree_to_execute="Main">)" +
                              std::string(kDoorTrees) + "</root>") {}
  EditorState& state() { return driver_.editor.state(); }
  void ShowTheRun() {
    ASSERT_GE(state().workspace.FindRun("robot:1"), 0);
    state().workspace.ShowRun(static_cast<std::size_t>(state().workspace.FindRun("robot:1")));
    driver_.Frames();
  }
  void SaveAs(const std::string& name) {
    driver_.Press('T', kCtrl | kShift);
    driver_.Frames();
    driver_.Type(name);
    driver_.Press(kKeyEnter);
    driver_.Frames();
  }

  TemporaryFile file_;
  Driver driver_;
};

TEST_F(RunTestMakerTest, WhatARobotDidBecomesATestThatPasses) {
  driver_.editor.Open(file_.path());
  ExecutedSource* robot = AddExecuted(driver_, "robot:1", 20);
  robot->tree.results["drive"] = Status::kSuccess;
  robot->Ticks(3);
  driver_.Frames();
  ShowTheRun();
  SaveAs("through the door");
  ASSERT_EQ(state().popup.kind, Popup::kNone) << state().popup.error;
  ASSERT_EQ(state().tests.all().size(), 1U);
  state().tests.Run(state().workspace.project(), "*");
  const ScenarioTest& test = state().tests.all()[0];
  EXPECT_EQ(test.state, ScenarioTest::State::kPassed)
      << test.problem << (test.differences.empty() ? "" : test.differences[0].got);

  std::string text = state().workspace.project().Find(file_.path())->text;
  text.replace(text.find("<Fallback"), 9, "<Sequence");
  text.replace(text.find("</Fallback"), 10, "</Sequence");
  state().workspace.project().SetText(file_.path(), "Type", text);
  state().tests.Run(state().workspace.project(), "*");
  EXPECT_EQ(state().tests.all()[0].state, ScenarioTest::State::kFailed) << "the tree was changed";
}

TEST_F(RunTestMakerTest, OfAMarkedStretchItTakesThat) {
  driver_.editor.Open(file_.path());
  AddExecuted(driver_, "robot:1", 20);
  ShowTheRun();
  const auto& run = state().workspace.run()->run();
  state().run.timelines["robot:1"].range = {run.TimeOf(0), run.TimeOf(4)};
  EXPECT_EQ(SaveRunAsTest(state(), "begins", 0).problem(), "");
  Diagnostics diagnostics;
  const auto suite = LoadScenarios(state().tests.all()[0].file, diagnostics);
  ASSERT_TRUE(suite) << diagnostics.ToString();
  EXPECT_LE(suite->scenarios[0].steps.size(), 5U);
  EXPECT_FALSE(SaveRunAsTest(state(), "begins", 0)) << "there is one of that name";
}

TEST_F(RunTestMakerTest, WithoutItsFileItSaysWhatIsMissing) {
  EXPECT_FALSE(SaveRunAsTest(state(), "a", 0));
  AddExecuted(driver_, "robot:1", 5);
  ShowTheRun();
  EXPECT_NE(SaveRunAsTest(state(), "a", 0).problem().find("open the file with the tree Main"),
            std::string::npos);
  EXPECT_EQ(SaveRunAsTest(state(), "", 0).problem(), "a name is needed");
}

}  // namespace
}  // namespace coppice::editor
