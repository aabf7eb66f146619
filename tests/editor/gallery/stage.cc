#include "tests/editor/gallery/stage.h"

#include <stdexcept>

namespace coppice::editor {

void Stage::Restart() {
  driver_.reset();
  EditorOptions options;
  options.settings.palette = look_.palette;
  options.scale = look_.scale;
  options.recent_file = folder_.folder() + "/state/recent";
  options.backup_folder = folder_.folder() + "/state/backup";
  options.keys_file = folder_.folder() + "/state/keys";
  options.marks_file = folder_.folder() + "/state/marks.json";
  driver_ = std::make_unique<Driver>(std::move(options));
  driver_->input.width = look_.width;
  driver_->input.height = look_.height;
  driver_->Frames();
}

std::string Stage::Write(const std::string& name, const std::string& text) const {
  const std::string path = folder_.folder() + "/" + name;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  std::ofstream(path) << text;
  return path;
}

void Stage::Open(const std::string& name, const std::string& text) {
  if (!driver_->editor.Open(Write(name, text))) throw std::logic_error("does not open: " + name);
  driver_->Frames(8);
  driver_->Press(kKeyHome);
  driver_->Frames(12);
}

void Stage::OpenBroken(const std::string& name, const std::string& text) {
  driver_->editor.Open(Write(name, text));
  driver_->Frames(8);
}

Box Stage::BoxOf(const std::string& path) const {
  if (!driver_->Has(path)) throw std::logic_error("no such item: " + path);
  return driver_->BoxOf(path);
}

void Stage::Click(const std::string& path) {
  driver_->ClickAt(BoxOf(path).center());
  driver_->Frames(12);
}

void Stage::Hover(const std::string& path) {
  driver_->MoveTo(BoxOf(path).center());
  driver_->Frames(40);  // until the explanation comes
}

void Stage::DragOnto(const std::string& from, const std::string& to) {
  DragTo(from, BoxOf(to).center());
}

void Stage::DragBehind(const std::string& from, const std::string& to) {
  const Box box = BoxOf(to);
  DragTo(from, {box.max.x - 3, box.center().y});
}

void Stage::DragTo(const std::string& from, Point to) {
  driver_->Carry(BoxOf(from).center(), to);
  driver_->Frames(8);
}

void Stage::Select(const std::string& node_path) {
  const std::uint32_t node = driver_->view().scene()->FindPath(node_path);
  if (node == kNoSceneNode) throw std::logic_error("no such node: " + node_path);
  driver_->view().Select(node);
  driver_->Frames(12);
}

void Stage::Run(const std::string& command) {
  if (!state().commands.Run(command)) throw std::logic_error("no such command: " + command);
  driver_->Frames(12);
}

ExecutedSource& Stage::AddRobot(const std::string& name, int ticks, bool is_robot) {
  auto source = std::make_unique<ExecutedSource>(name, RobotTrees(), is_robot);
  ExecutedSource& added = *source;
  TickPatrol(added, ticks);
  driver_->editor.AddRun(std::move(source));
  driver_->Frames(8);
  driver_->Press(kKeyHome);
  driver_->Frames(12);
  return added;
}

const std::string& RobotTrees() {
  static const std::string kTrees = R"(<BehaviorTree ID="Main"><ReactiveSequence name="mission">
  <RunOnce name="charged"><Script name="full" code="battery := 0.5"/></RunOnce>
  <ReactiveFallback name="patrol">
    <Sequence name="recharge when low">
      <ScriptCondition name="battery low?" code="battery &lt; 0.3"/>
      <SubTree ID="GoTo" name="to the station" place="station"/>
      <Do as="charge" name="Charge"/>
    </Sequence>
    <Sequence name="round">
      <Do as="choose" name="ChooseWaypoint" count="{rounds}"/>
      <Script name="drain" code="battery = battery - 0.004"/>
      <SubTree ID="GoTo" name="to the waypoint" place="waypoint"/>
      <Do as="say" name="Say" count="{said}"/>
    </Sequence>
  </ReactiveFallback>
</ReactiveSequence></BehaviorTree>
<BehaviorTree ID="GoTo">
  <Fallback name="drive or wait">
    <Sequence name="through the door">
      <Is as="open" name="IsDoorOpen"/>
      <Do as="drive" name="Drive" count="{steps}"/>
    </Sequence>
    <ForceFailure name="give up"><Do as="wait" name="Wait" count="{waits}"/></ForceFailure>
  </Fallback>
</BehaviorTree>)";
  return kTrees;
}

// A round of 20 ticks: drives for most of it, in every third round the door is closed.
void TickPatrol(ExecutedSource& robot, int ticks) {
  constexpr std::uint64_t kRound = 20;
  for (int i = 0; i < ticks; ++i) {
    const std::uint64_t tick = robot.tree.executor.ticks();
    const bool arrives = tick % kRound >= 16;
    const bool is_closed = tick / kRound % 3 == 2 && tick % kRound < 6;
    robot.tree.results["drive"] = arrives ? Status::kSuccess : Status::kRunning;
    robot.tree.results["open"] = is_closed ? Status::kFailure : Status::kSuccess;
    robot.tree.results["wait"] = is_closed ? Status::kRunning : Status::kSuccess;
    robot.tree.results["say"] = tick % kRound < 18 ? Status::kRunning : Status::kSuccess;
    robot.Ticks(1);
  }
}

}  // namespace coppice::editor
