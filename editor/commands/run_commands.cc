#include "editor/commands/run_commands.h"

#include <charconv>
#include <utility>

#include "bt_core/data/value_bytes.h"
#include "editor/commands/run_files.h"
#include "editor/live/key_item.h"
#include "editor/workspace/run_test_maker.h"

namespace coppice::editor {
namespace {

using Kind = LiveCommand::Kind;

constexpr double kFaster = 2;

std::string RobotOf(const EditorState& state) {
  const RunView* run = state.workspace.run();
  return run && run->source().is_robot() ? run->name() : "";
}

bool IsStopped(const RunView& run) { return run.stop().where != DebugStop::Where::kNowhere; }

void Play(RunView& run) {
  Playhead& head = run.playhead();
  if (head.is_playing()) {
    head.Stop();
  } else {
    head.Play();
  }
}

void ChangeSpeed(RunView& run, double factor) {
  Playhead& head = run.playhead();
  const bool wraps = factor > 1 && head.speed() >= 32;
  head.SetSpeed(wraps ? 0.125 : head.speed() * factor);
}

void StepToChange(EditorState& state, RunView& run, bool forward) {
  const TreeView* view = state.workspace.view();
  const bool selected = view && view->selected() != kNoSceneNode;
  const NodeIndex node = selected ? view->selected_run_node() : kRootNode;
  if (node != kNoNode) run.playhead().StepToChange(node, forward);
}

const WantedHook* BreakpointOf(EditorState& state) {
  const std::string path = SelectedRunPath(state);
  return path.empty() ? nullptr : state.workspace.hooks.FindAt(RobotOf(state), path, true);
}

// "battery < 20 #3": the condition, and the hit from which on the hook acts.
Outcome ChangeCondition(HookList& hooks, std::uint32_t number, const std::string& text) {
  const WantedHook* wanted = hooks.Find(number);
  if (!wanted) return Problem{"the breakpoint no longer exists"};
  Hook hook = wanted->hook;
  const std::size_t hash = text.rfind('#');
  hook.condition = text.substr(0, hash);
  while (!hook.condition.empty() && hook.condition.back() == ' ') hook.condition.pop_back();
  hook.from_hit = 1;
  if (hash != std::string::npos) {
    const char* const end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data() + hash + 1, end, hook.from_hit);
    if (error != std::errc() || at != end || hook.from_hit == 0) {
      return Problem{"expected a number after #"};
    }
  }
  hooks.Change(number, hook);
  return {};
}

void ToggleBreakpoint(EditorState& state, double now) {
  HookList& hooks = state.workspace.hooks;
  const std::string path = SelectedRunPath(state);
  if (path.empty()) return state.Notify("Select a node first", now, true);
  if (const WantedHook* there = BreakpointOf(state)) return hooks.Remove(there->number);
  Hook hook;
  hook.path = path;
  hooks.Add(RobotOf(state), hook);
  state.run.tab = RunTab::kHooks;
}

void SwitchBreakpoint(EditorState& state, double now) {
  const WantedHook* there = BreakpointOf(state);
  if (!there) return state.Notify("The node has no breakpoint: F9 sets one", now, true);
  Hook hook = there->hook;
  hook.enabled = !hook.enabled;
  state.workspace.hooks.Change(there->number, hook);
}

void AskForConditionHere(EditorState& state, double now) {
  if (!BreakpointOf(state)) ToggleBreakpoint(state, now);
  const WantedHook* there = BreakpointOf(state);
  if (!there) return;
  AskForCondition(state, there->number);
}

// The key whose history is shown.
void AskForValue(EditorState& state) {
  RunView* run = state.workspace.run();
  if (!run || !run->tree()) return;
  const TreeDescription& tree = *run->tree()->description();
  const std::optional<SlotIndex> key = KeyOfItem(tree, state.blackboard.shown_key);
  if (!key) return;
  const DescribedSlot& slot = tree.slots[*key];
  const auto& values = run->follower().values();
  state.Ask({"New value of " + slot.name + " (" + slot.type + "), as in the XML",
             [&state, key = *key, tree = run->tree()](const std::string& value) {
               RunView* shown = state.workspace.run();
               if (!shown || shown->tree() != tree)
                 return Outcome(Problem{"the key no longer exists"});
               return state.blackboard.writes.Send(*shown, key, value);
             },
             {}},
            *key < values.size() ? PrintValueBytes(values[*key]) : "");
}

class RunCommands {
 public:
  explicit RunCommands(EditorState& state) : state_(state) {}

  void AddAll() {
    AddPlayhead();
    AddDebugger();
    AddBreakpoints();
    AddFaults();
    AddViews();
  }

 private:
  // A command that needs a run; its keys are its own while one is shown.
  void Add(std::string id, std::string title, KeyChord keys, std::function<void(RunView&)> run) {
    EditorCommand command{std::move(id), std::move(title), keys, {}, {}};
    command.run = [&s = state_, run = std::move(run)] {
      if (RunView* view = s.workspace.run()) run(*view);
    };
    command.when = [&s = state_] { return s.workspace.run() != nullptr; };
    state_.commands.Add(std::move(command));
  }
  // The same for robots only; a simulation has keys of its own for it.
  void AddForRobot(std::string id, std::string title, KeyChord keys,
                   std::function<void(RunView&)> run) {
    EditorCommand command{std::move(id), std::move(title), keys, {}, {}};
    command.run = [&s = state_, run = std::move(run)] {
      if (!RobotOf(s).empty()) run(*s.workspace.run());
    };
    command.when = [&s = state_] { return !RobotOf(s).empty(); };
    state_.commands.Add(std::move(command));
  }
  void AddAlways(std::string id, std::string title, KeyChord keys, std::function<void()> run) {
    state_.commands.Add({std::move(id), std::move(title), keys, std::move(run)});
  }

  void AddPlayhead() {
    Add("run.back", "One tick back", {kKeyLeft}, [](RunView& run) { run.playhead().Step(-1); });
    Add("run.forward", "One tick forward", {kKeyRight},
        [](RunView& run) { run.playhead().Step(1); });
    Add("run.change_before", "To the previous change of the node", {kKeyLeft, kShift},
        [&s = state_](RunView& run) { StepToChange(s, run, false); });
    Add("run.next_change", "To the next change of the node", {kKeyRight, kShift},
        [&s = state_](RunView& run) { StepToChange(s, run, true); });
    Add("run.begin", "To the beginning of the run", {kKeyHome, kCtrl},
        [](RunView& run) { run.playhead().GoToTick(0); });
    Add("run.now", "Back to now", {'L'}, [](RunView& run) { run.playhead().GoToNow(); });
    Add("run.play", "Play or stop", {'P'}, [](RunView& run) { Play(run); });
    Add("run.faster", "Play faster", {']'}, [](RunView& run) { ChangeSpeed(run, kFaster); });
    Add("run.slower", "Play slower", {'['}, [](RunView& run) { ChangeSpeed(run, 1 / kFaster); });
    AddWalk("run.walk_left", "walk.left", "Walk left", kKeyLeft);
    AddWalk("run.walk_right", "walk.right", "Walk right", kKeyRight);
  }

  // The arrows alone move the playhead.
  void AddWalk(std::string id, std::string walk, std::string title, Key key) {
    Add(std::move(id), std::move(title), {key, kCtrl},
        [&s = state_, walk = std::move(walk)](RunView&) { s.commands.Run(walk); });
  }

  void AddDebugger() {
    // The largest key plays records, but nobody stops a robot with it by accident.
    Add("run.play_record", "Play or stop a record", {kKeySpace}, [&s = state_](RunView& run) {
      if (!run.source().is_robot()) return Play(run);
      const std::string keys = ToString(s.commands.Find("run.pause")->keys);
      s.Notify(keys + (IsStopped(run) ? " continues the robot" : " pauses the robot"), s.now);
    });
    AddForRobot("run.pause", "Pause or continue the robot", {kKeySpace, kShift}, [](RunView& run) {
      run.Send(MakeCommand(IsStopped(run) ? Kind::kContinue : Kind::kPause));
    });
    AddSend("run.continue", "Continue the robot", {kKeyF1 + 4}, Kind::kContinue);
    AddSend("run.step_tick", "One tick of the robot", {kKeyF1 + 9}, Kind::kStepTick);
    AddSend("run.step_node", "Step to the next node of the robot", {kKeyF1 + 9, kShift},
            Kind::kStepNode);
    AddContinue("run.continue_success", "Continue: the node has succeeded", Status::kSuccess);
    AddContinue("run.continue_failure", "Continue: the node has failed", Status::kFailure);
    AddContinue("run.continue_skipped", "Continue: the node is skipped", Status::kSkipped);
  }

  void AddSend(std::string id, std::string title, KeyChord keys, Kind kind) {
    AddForRobot(std::move(id), std::move(title), keys, [kind](RunView& run) {
      run.playhead().GoToNow();
      run.Send(MakeCommand(kind));
    });
  }

  void AddContinue(std::string id, std::string title, Status result) {
    AddForRobot(std::move(id), std::move(title), {}, [result](RunView& run) {
      LiveCommand command = MakeCommand(Kind::kContinue);
      command.result = result;
      run.Send(std::move(command));
    });
  }

  void AddBreakpoints() {
    AddAlways("run.breakpoint", "Breakpoint at the node", {kKeyF1 + 8},
              [&s = state_] { ToggleBreakpoint(s, s.now); });
    AddAlways("run.breakpoint_enable", "Switch the breakpoint on or off", {kKeyF1 + 8, kShift},
              [&s = state_] { SwitchBreakpoint(s, s.now); });
    AddAlways("run.breakpoint_condition", "Condition of the breakpoint", {kKeyF1 + 8, kCtrl},
              [&s = state_] { AskForConditionHere(s, s.now); });
    AddAlways("run.breakpoint_path", "Breakpoint at a path", {}, [&s = state_] {
      s.Ask({"Breakpoint at a path, as in sub/work or sub/Drive::7; \"if\" narrows it later",
             [&s](const std::string& path) {
               Hook hook;
               hook.path = path;
               if (!path.empty()) s.workspace.hooks.Add(RobotOf(s), hook);
               return path.empty() ? Problem{"a path is needed"} : Outcome();
             },
             {}});
    });
  }

  void AddFaults() {
    AddForce("run.force_success", "Force SUCCESS on the node", Status::kSuccess);
    AddForce("run.force_failure", "Force FAILURE on the node", Status::kFailure);
    AddForce("run.force_running", "Force RUNNING on the node", Status::kRunning);
    AddForce("run.force_skipped", "Force SKIPPED on the node", Status::kSkipped);
    AddAlways("run.delay", "Delay the node by a second", {}, [&s = state_] {
      Hook fault;
      fault.action = HookAction::kDelay;
      fault.delay = std::chrono::seconds(1);
      ToggleFault(s, fault, s.now);
    });
    AddAlways("run.clear_faults", "Clear all faults", {'F', kCtrl | kAlt},
              [&s = state_] { s.workspace.hooks.RemoveFaults(); });
  }

  void AddForce(std::string id, std::string title, Status status) {
    AddAlways(std::move(id), std::move(title), {}, [&s = state_, status] {
      Hook fault;
      fault.action = HookAction::kReplace;
      fault.status = status;
      ToggleFault(s, fault, s.now);
    });
  }

  void AddViews() {
    AddTab("run.why", "Why", {'W'}, RunTab::kWhy);
    AddTab("run.running", "Running now", {'N'}, RunTab::kRunning);
    AddTab("run.robots", "Robots: those that need somebody first", {'O'}, RunTab::kRobots);
    AddTab("run.hooks", "Breakpoints and faults", {'K'}, RunTab::kHooks);
    AddTab("run.statistics", "Statistics", {'S'}, RunTab::kStatistics);
    AddTab("run.comparison", "Comparison", {}, RunTab::kComparison);
    AddTab("run.table", "Table: the shown key, or the robot's processes", {'Y'}, RunTab::kTable);
    AddTab("run.pictures", "Face: what the robot shows to people now", {'V'}, RunTab::kPictures);
    AddTab("run.coverage", "Coverage by random runs", {}, RunTab::kCoverage);
    Add("run.follow", "Follow what runs", {'F'},
        [&s = state_](RunView&) { s.run.follow.is_on = !s.run.follow.is_on; });
    Add("run.heat", "Heat: time, ticks, failures, never ticked, off", {'H'},
        [&s = state_](RunView&) {
          const int next = s.run.heat ? static_cast<int>(*s.run.heat) + 1 : 0;
          s.run.heat.reset();
          if (next <= static_cast<int>(HeatMode::kNeverTicked))
            s.run.heat = static_cast<HeatMode>(next);
        });
    AddAlways("blackboard.selection", "Only the keys of the selection", {'B'}, [&s = state_] {
      s.blackboard.selected_keys_only = !s.blackboard.selected_keys_only;
    });
    Add("blackboard.write", "Write the key", {'E', kCtrl | kAlt},
        [&s = state_](RunView&) { AskForValue(s); });
    Add("run.close", "Close the robot or record", {'W', kCtrl}, [&s = state_](RunView& run) {
      const int at = s.workspace.FindRun(run.name());
      s.workspace.CloseRun(static_cast<std::size_t>(at), s.now);
    });
    Add("run.save_test", "Make a test of the run or of its marked stretch", {'T', kCtrl | kShift},
        [&s = state_](RunView&) {
          s.Ask({"Name of the test",
                 [&s](const std::string& name) { return SaveRunAsTest(s, name, s.now); },
                 {}});
        });
  }

  void AddTab(std::string id, std::string title, KeyChord keys, RunTab tab) {
    Add(std::move(id), std::move(title), keys, [&s = state_, tab](RunView&) { s.run.tab = tab; });
  }

  EditorState& state_;
};

}  // namespace

void AddRunCommands(EditorState& state) {
  RunCommands(state).AddAll();
  AddRunFileCommands(state);
}

std::string SelectedRunPath(EditorState& state) {
  const TreeView* view = state.workspace.view();
  if (!view || view->selected() == kNoSceneNode) return {};
  const SceneNode& node = view->scene()->nodes[view->selected()];
  if (const RunView* run = state.workspace.run()) {
    return node.run_node == kNoNode || !run->tree()
               ? ""
               : run->tree()->description()->nodes[node.run_node].path;
  }
  const Document& document = *state.workspace.forest()->documents()[node.document];
  const std::string_view name = document.AttributeValue(document.element(node.element), "name");
  const std::string own = name.empty()
                              ? std::string(node.id) + "::" + std::to_string(view->selected() + 1)
                              : std::string(name);
  return node.scope == 0 ? own : view->scene()->scopes[node.scope] + "/" + own;
}

void SelectRunNode(EditorState& state, NodeIndex node) {
  TreeView* view = state.workspace.view();
  if (!view || node >= view->scene()->of_run_node.size()) return;
  const std::uint32_t in_scene = view->scene()->of_run_node[node];
  if (in_scene == kNoSceneNode) return;
  view->Select(in_scene);
  view->RevealReadable(state.screen.canvas_size);
}

void AskForCondition(EditorState& state, std::uint32_t number) {
  const WantedHook* hook = state.workspace.hooks.Find(number);
  if (!hook) return;
  state.Ask(
      {"Condition of the breakpoint, such as battery < 20; \"#3\" after it: from the third hit on",
       [&state, number](const std::string& text) {
         return ChangeCondition(state.workspace.hooks, number, text);
       },
       {}},
      hook->hook.from_hit > 1 ? hook->hook.condition + " #" + std::to_string(hook->hook.from_hit)
                              : hook->hook.condition);
}

void ToggleFault(EditorState& state, Hook fault, double now) {
  HookList& hooks = state.workspace.hooks;
  fault.path = SelectedRunPath(state);
  if (fault.path.empty()) return state.Notify("Select a node first", now, true);
  const WantedHook* there = hooks.FindAt(RobotOf(state), fault.path, false);
  const bool same =
      there && there->hook.action == fault.action && there->hook.status == fault.status;
  if (there) hooks.Remove(there->number);
  if (!same) hooks.Add(RobotOf(state), std::move(fault));
  state.run.tab = RunTab::kHooks;
}

}  // namespace coppice::editor
