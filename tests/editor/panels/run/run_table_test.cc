#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"
#include "tests/editor/sample_trees.h"

namespace coppice::editor {
namespace {

class RunTableTest : public testing::Test {
 protected:
  RunTableTest() {
    auto source = std::make_unique<ExecutedSource>("robot:1", kProcessTrees);
    robot_ = source.get();
    robot_->tree.results["watch"] = Status::kRunning;
    Send(kProcessRows);
    robot_->Ticks(10);
    Send(R"([{"name":"ekf","state":"READY"}])");
    robot_->Ticks(10);
    driver_.editor.AddRun(std::move(source));
    driver_.Frames();
  }
  void Send(const std::string& rows) {
    robot_->tree.executor.Writer<std::string>("processes").Send(rows);
  }
  EditorState& state() { return driver_.editor.state(); }

  Driver driver_;
  ExecutedSource* robot_ = nullptr;
};

TEST_F(RunTableTest, ShowsAListOfObjectsAndItsHistory) {
  EXPECT_TRUE(driver_.Click("blackboard/Main/processes"));
  driver_.Frames();
  EXPECT_EQ(state().run.tab, RunTab::kTable);
  EXPECT_TRUE(driver_.Has("run/table/0"));
  EXPECT_FALSE(driver_.Has("run/table/1"));
  state().workspace.run()->playhead().GoToTick(5);
  driver_.MoveTo({600, 300});
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("run/table/4")) << "as it was then";
  EXPECT_GT(
      driver_.CountColor(driver_.BoxOf("run/table/0"), GetPalette(PaletteName::kDark).success, 40),
      5)
      << "READY is green";
  driver_.Picture("table_dark");
  state().screen.palette = PaletteName::kLight;
  driver_.Frames();
  driver_.Picture("table_light");
}

TEST_F(RunTableTest, AClickOnAColumnSorts) {
  driver_.Press('Y');
  state().workspace.run()->playhead().GoToTick(5);
  driver_.Frames();
  EXPECT_TRUE(driver_.Click("run/table/sort/state"));
  driver_.Frames();
  EXPECT_EQ(state().run.table_sort.column, "state");
  EXPECT_FALSE(state().run.table_sort.descending);
  EXPECT_TRUE(driver_.Click("run/table/sort/state"));
  driver_.Frames();
  EXPECT_TRUE(state().run.table_sort.descending);
  EXPECT_GT(
      driver_.CountColor(driver_.BoxOf("run/table/2"), GetPalette(PaletteName::kDark).success, 40),
      5)
      << "STOPPED, STARTING, READY, GIVEN_UP, BACKING_OFF";
}

TEST_F(RunTableTest, WithoutATableItSaysSo) {
  Send("nothing");
  robot_->Ticks(1);
  driver_.Press('Y');
  driver_.Frames();
  EXPECT_FALSE(driver_.Has("run/table/head"));
}

}  // namespace
}  // namespace coppice::editor
