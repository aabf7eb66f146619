#include <memory>
#include <string>
#include <utility>

#include "editor/commands/run_commands.h"
#include "tests/editor/gallery/scenes.h"
#include "tests/editor/robot_face.h"
#include "tests/editor/sample_trees.h"

namespace coppice::editor {
namespace {

constexpr char kDrive[] = "1.2.2.3.1.1.2";  // on the canvas, in the tree of the waypoint

void Live(Stage& stage) {
  stage.AddRobot("robot-1:1667", 150);
  stage.Run("tree.open_subtrees");
  stage.Select(kDrive);
}

void LiveAndFile(Stage& stage) {
  stage.Open("small.xml", kSmallFile);
  stage.AddRobot("robot-1:1667", 30);
}

void Paused(Stage& stage) {
  ExecutedSource& robot = stage.AddRobot("robot-1:1667", 150);
  stage.Run("tree.open_subtrees");
  stage.Select(kDrive);
  stage.Run("run.breakpoint");
  const auto& nodes = stage.state().workspace.run()->tree()->description()->nodes;
  const std::string path = "to the waypoint/Drive";
  for (NodeIndex i{0}; i < nodes.size(); ++i) {
    if (nodes[i].path == path) robot.StopBefore(i);
  }
  stage.driver().Frames(8);
  stage.Run("view.zoom_100");
  stage.Run("view.fit_selection");
}

void Faults(Stage& stage) {
  Live(stage);
  stage.Run("run.force_failure");
  stage.Run("view.fit_all");
}

void ManyFaults(Stage& stage) {
  Faults(stage);
  stage.Select("1.2.2.4");
  stage.Run("run.delay");
  stage.Select("1.2.1.1");
  stage.Run("run.force_skipped");
  stage.Run("run.breakpoint");
}

void InThePast(Stage& stage) {
  Live(stage);
  stage.state().workspace.run()->playhead().GoToTick(43);
  stage.driver().Frames(12);
}

void Tab(Stage& stage, const char* command) {
  Live(stage);
  stage.Run(command);
}

void WhyNot(Stage& stage) {
  Live(stage);
  stage.Select("1.2.1.3");
  stage.Run("run.why");
}

void NoHooks(Stage& stage) { Tab(stage, "run.hooks"); }

void Heat(Stage& stage, int times) {
  Live(stage);
  for (int i = 0; i < times; ++i) stage.Run("run.heat");
  stage.Run("run.statistics");
}

// As the robot listens: ears forward, strips green.
void ShownFace(Stage& stage) {
  ExecutedSource& robot = stage.AddRobot("robot-1:1667", 150);
  robot.Show(RingEyes("LISTENING"));
  robot.Show(Strip("ears", "85° 85°"));
  robot.Show(Strip("arms", "0° 0°"));
  stage.driver().Frames();
  stage.Run("run.pictures");
}

void FaceInThePast(Stage& stage) {
  ShownFace(stage);
  stage.state().workspace.run()->playhead().GoToTick(43);
  stage.driver().Frames(12);
}

void FaceOfNobody(Stage& stage) {
  ShownFace(stage);
  stage.AddRobot("robot-2:1667", 40);
}

void Log(Stage& stage) {
  Live(stage);
  LogPoint point;
  point.run = "robot-1:1667";
  point.path = SelectedRunPath(stage.state());
  static_cast<void>(ReadLogPoint("step {count} if count > 3", point));
  stage.state().workspace.log_points.Add(point);
  point.path = "door";
  static_cast<void>(ReadLogPoint("", point));
  stage.state().workspace.log_points.Add(point);
  stage.Run("run.log");
}

void PinnedLanes(Stage& stage) {
  Live(stage);
  stage.Run("run.pin");
  stage.driver().Frames(8);
}

void Table(Stage& stage) {
  auto source = std::make_unique<ExecutedSource>("robot-1:1669", kProcessTrees);
  source->tree.executor.Writer<std::string>("processes").Send(kProcessRows);
  source->tree.results["watch"] = Status::kRunning;
  source->Ticks(30);
  stage.driver().editor.AddRun(std::move(source));
  stage.driver().Frames(8);
  stage.Run("run.table");
}

void PlayedRecord(Stage& stage) {
  stage.AddRobot("/var/log/robot/night.coppice", 300, false);
  stage.Run("run.play");
  stage.driver().Frames(10);
}

void TwoRuns(Stage& stage) {
  stage.AddRobot("monday.coppice", 150, false);
  ExecutedSource& other = stage.AddRobot("tuesday.coppice", 60, false);
  other.tree.results["open"] = Status::kFailure;
  other.tree.results["wait"] = Status::kFailure;
  other.Ticks(40);
  stage.driver().Frames(8);
  stage.Run("run.comparison");
}

void Compared(Stage& stage) {
  TwoRuns(stage);
  stage.Click("run/compare/monday.coppice");
  stage.Run("tree.open_subtrees");
  stage.Run("view.fit_all");
}

void NothingToCompareWith(Stage& stage) { Tab(stage, "run.comparison"); }

void Lost(Stage& stage) {
  ExecutedSource& robot = stage.AddRobot("robot-1:1667", 150);
  stage.Select("1.2.2");
  robot.Disconnect("no answer for 3 s; next try in 2 s");
  stage.driver().Frames(12);
}

void Connecting(Stage& stage) {
  static_cast<void>(stage.state().services.connect("127.0.0.1:9"));  // where nobody listens
  stage.driver().Frames(12);
}

void LostTicks(Stage& stage) {
  ExecutedSource& robot = stage.AddRobot("robot-1:1667", 60);
  robot.Lose(30);
  TickPatrol(robot, 60);
  stage.driver().Frames(8);
  stage.Select("1.2.2");
  stage.state().workspace.run()->playhead().GoToTick(30);
  stage.driver().Frames(4);
  stage.Run("run.bookmark");
  stage.state().workspace.run()->playhead().GoToTick(80);
  stage.driver().Frames(4);
}

void KeyHistory(Stage& stage) {
  Live(stage);
  stage.Click("blackboard/Main/battery");
}

void KeysOfSelection(Stage& stage) {
  Live(stage);
  stage.Run("blackboard.selection");
}

void NoKeysOfSelection(Stage& stage) {
  Live(stage);
  stage.Select("1.2");
  stage.Run("blackboard.selection");
}

void Range(Stage& stage) {
  Live(stage);
  Driver& driver = stage.driver();
  const Box lanes = driver.BoxOf("timeline/lanes");
  driver.Hold(kShift);
  driver.Drag({lanes.min.x + 0.3F * lanes.width(), lanes.center().y},
              {lanes.min.x + 0.6F * lanes.width(), lanes.center().y});
  driver.Hold(kNoModifier);
  stage.Run("run.statistics");
}

void ManyRobots(Stage& stage) {
  stage.AddRobot("robot-1:1667", 80);
  stage.AddRobot("robot-2:1667", 40).Disconnect("connection refused");
  stage.AddRobot("a-robot-with-a-long-name.fleet.example.org:1667", 40);
  stage.AddRobot("/var/log/robot/night.coppice", 40, false);
  stage.Click("strip/robot-1:1667");
}

void Groot2Robot(Stage& stage) {
  ScriptedRobot& robot = *stage.driver().AddRobot("robot-3:1668", kLiveTree);
  robot.Set(1, Status::kRunning);
  robot.Set(2, Status::kIdle, Status::kSuccess);
  robot.Set(3, Status::kRunning);
  robot.Tick();
  stage.driver().Frames(8);
  stage.driver().Press(kKeyHome);
  stage.driver().Frames(8);
}

void StripTooltip(Stage& stage) {
  Lost(stage);
  stage.Hover("strip/robot-1:1667");
}

void WriteKey(Stage& stage) {
  KeyHistory(stage);
  stage.Run("blackboard.write");
}

void Condition(Stage& stage) {
  Live(stage);
  stage.Run("run.breakpoint");
  stage.Run("run.breakpoint_condition");
}

}  // namespace

std::vector<GalleryScene> RunScenes() {
  return {{"live", Live},
          {"live_and_file", LiveAndFile},
          {"paused", Paused},
          {"fault", Faults},
          {"many_faults", ManyFaults},
          {"in_the_past", InThePast},
          {"why_not", WhyNot},
          {"running_now", [](Stage& stage) { Tab(stage, "run.running"); }},
          {"no_hooks", NoHooks},
          {"statistics", [](Stage& stage) { Tab(stage, "run.statistics"); }},
          {"heat_time", [](Stage& stage) { Heat(stage, 1); }},
          {"heat_ticks", [](Stage& stage) { Heat(stage, 2); }},
          {"heat_failures", [](Stage& stage) { Heat(stage, 3); }},
          {"heat_never_ticked", [](Stage& stage) { Heat(stage, 4); }},
          {"face", ShownFace},
          {"face_in_the_past", FaceInThePast},
          {"no_face", FaceOfNobody},
          {"log", Log},
          {"no_log_points", [](Stage& stage) { Tab(stage, "run.log"); }},
          {"table", Table},
          {"pinned_lanes", PinnedLanes},
          {"record", PlayedRecord},
          {"two_runs", TwoRuns},
          {"compared", Compared},
          {"nothing_to_compare_with", NothingToCompareWith},
          {"lost", Lost},
          {"connecting", Connecting},
          {"gap", LostTicks},
          {"key_history", KeyHistory},
          {"keys_of_selection", KeysOfSelection},
          {"no_keys_of_selection", NoKeysOfSelection},
          {"range", Range},
          {"many_robots", ManyRobots},
          {"small_robot", Groot2Robot},
          {"strip_tooltip", StripTooltip},
          {"write_key", WriteKey},
          {"breakpoint_condition", Condition}};
}

}  // namespace coppice::editor
