#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

constexpr char kTrees[] = R"(<BehaviorTree ID="Main"><Sequence name="monitor">
  <ForceSuccess><WasEntryUpdated name="changed" entry="{processes}"/></ForceSuccess>
  <Do as="watch" name="watch" count="{watched}"/></Sequence></BehaviorTree>)";

constexpr char kBefore[] = R"([
  {"name": "roscore", "group": "core", "state": "READY", "pid": 4211, "restarts": 0,
   "escalation": "group", "message": ""},
  {"name": "ekf", "group": "odometry_filter", "state": "BACKING_OFF", "pid": 0, "restarts": 4,
   "escalation": "closure", "message": "ended by signal 11"},
  {"name": "move_base", "group": "navigation", "state": "STARTING", "pid": 4299, "restarts": 1,
   "escalation": "group", "message": "waits for ekf"},
  {"name": "logger", "group": "log", "state": "STOPPED", "pid": 0, "restarts": 0,
   "escalation": "group", "message": ""},
  {"name": "camera", "group": "sensors", "state": "GIVEN_UP", "pid": 0, "restarts": 12,
   "escalation": "person", "message": "restarted 12 times in 10 minutes; a person was asked"}])";

class RunTableTest : public testing::Test {
 protected:
  RunTableTest() {
    auto source = std::make_unique<ExecutedSource>("robot:1", kTrees);
    robot_ = source.get();
    robot_->tree.results["watch"] = Status::kRunning;
    Send(kBefore);
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
  EXPECT_EQ(state().run_tab, RunTab::kTable);
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
  state().palette = PaletteName::kLight;
  driver_.Frames();
  driver_.Picture("table_light");
}

TEST_F(RunTableTest, AClickOnAColumnSorts) {
  driver_.Press('Y');
  state().workspace.run()->playhead().GoToTick(5);
  driver_.Frames();
  EXPECT_TRUE(driver_.Click("run/table/sort/state"));
  driver_.Frames();
  EXPECT_EQ(state().table_sort.column, "state");
  EXPECT_FALSE(state().table_sort.descending);
  EXPECT_TRUE(driver_.Click("run/table/sort/state"));
  driver_.Frames();
  EXPECT_TRUE(state().table_sort.descending);
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
