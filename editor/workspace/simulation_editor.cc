#include "editor/workspace/simulation_editor.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "bt_core/model/write_file.h"
#include "editor/simulation/script_text.h"

namespace coppice::editor {
namespace {

constexpr Duration kLongestWait = std::chrono::hours(1);  // for a change

constexpr std::uint64_t kLargestSeed = 1'000'000'000'000'000;
constexpr std::uint64_t kMostTicks = 100'000;
constexpr std::uint64_t kMostRuns = 10'000'000;

// Nothing if the text is no whole number up to that.
std::optional<std::uint64_t> NumberIn(const std::string& text, std::uint64_t most) {
  const bool digits = !text.empty() && text.size() < 19 &&
                      text.find_first_not_of("0123456789") == std::string::npos;
  if (!digits || std::stoull(text) > most) return std::nullopt;
  return std::stoull(text);
}

std::string Trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string FirstProblem(const Diagnostics& diagnostics) {
  const auto& all = diagnostics.all();
  const auto error = std::find_if(all.begin(), all.end(), [](const Diagnostic& problem) {
    return problem.severity == Severity::kError;
  });
  return error == all.end() ? std::string() : ToString(*error);
}

std::string NameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

}  // namespace

void SimulationEditor::Start() {
  Workspace& workspace = state_.workspace;
  if (!workspace.file() || workspace.tree() < 0) {
    return state_.Notify("Show a tree of a file first: that is what is simulated", now_, true);
  }
  Diagnostics diagnostics;
  auto run = state_.simulator.Start(workspace.project(), workspace.file()->path,
                                    workspace.ShownTreeId(), diagnostics);
  if (const std::string problem = FirstProblem(diagnostics); !problem.empty()) {
    state_.Notify(problem, now_, true);
  }
  if (!run) return;
  state_.coverage.Clear();
  const int old = workspace.FindRun(Simulator::kName);
  if (old >= 0) workspace.CloseRun(static_cast<std::size_t>(old), now_);
  workspace.AddRun(std::move(run));
  workspace.ShowRun(workspace.runs().size() - 1);
}

void SimulationEditor::End() {
  const int run = state_.workspace.FindRun(Simulator::kName);
  if (run < 0) return;
  const std::string path = state_.simulator.path();
  state_.workspace.CloseRun(static_cast<std::size_t>(run), now_);
  const auto& files = state_.workspace.files();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].path != path) continue;
    const int tree = files[i].forest->Find(state_.simulator.tree_id());
    state_.workspace.ShowFileTree(i, tree >= 0 ? tree : files[i].forest->main_tree(), now_);
  }
}

bool SimulationEditor::IsShown() const {
  const RunView* run = state_.workspace.run();
  return run && run->source().is_simulation() && state_.simulator.get();
}

Simulation* SimulationEditor::AtPlayhead() {
  if (!IsShown()) return nullptr;
  Simulation& simulation = *state_.simulator.get();
  Playhead& playhead = state_.workspace.run()->playhead();
  if (playhead.is_at_now()) {
    simulation.GoToEnd();
  } else {
    simulation.GoTo(playhead.tick());
  }
  if (state_.simulator.is_playing()) playhead.GoToNow();
  return &simulation;
}

Simulation* SimulationEditor::GoOn() {
  Simulation* const simulation = AtPlayhead();
  if (simulation) state_.workspace.run()->playhead().GoToNow();
  return simulation;
}

void SimulationEditor::PlayOrPause() {
  if (state_.simulator.is_playing()) return state_.simulator.Pause();
  if (GoOn()) state_.simulator.Play();
}

void SimulationEditor::Tick() {
  state_.simulator.Pause();
  if (Simulation* simulation = GoOn()) {
    state_.simulator.SetResult(simulation->Tick(state_.simulator.period()));
  }
}

void SimulationEditor::TickUntilChange() {
  state_.simulator.Pause();
  Simulation* simulation = GoOn();
  if (!simulation) return;
  const Duration before = simulation->now();
  state_.simulator.SetResult(simulation->TickUntilChange(state_.simulator.period(), kLongestWait));
  if (simulation->now() - before >= kLongestWait) {
    state_.Notify("nothing has changed for an hour of the simulation", now_, true);
  }
}

void SimulationEditor::TickUntilTicked() {
  state_.simulator.Pause();
  Simulation* simulation = GoOn();
  const TreeView* view = state_.workspace.view();
  const NodeIndex node = view ? view->selected_run_node() : kNoNode;
  if (!simulation || node == kNoNode) return;
  RunView& run = *state_.workspace.run();
  const Duration before = simulation->now();
  while (simulation->now() - before < kLongestWait) {
    const std::size_t first = run.run().size();
    state_.simulator.SetResult(simulation->Tick(state_.simulator.period()));
    run.Update(state_.workspace.hooks, now_);
    const std::size_t end = run.run().size();
    if (end == first) return;
    const Lane& lane = run.run().TracksAt(first).LaneOf(node);
    if (lane.Seen(first, end) & ~SetOf(Status::kIdle)) return;
  }
  state_.Notify("the node was not ticked for an hour of the simulation", now_, true);
}

void SimulationEditor::Back() {
  state_.simulator.Pause();
  Simulation* simulation = AtPlayhead();
  if (!simulation) return;
  if (!simulation->Back()) return state_.Notify("this is the beginning", now_, true);
  RunView& run = *state_.workspace.run();
  run.Update(state_.workspace.hooks, now_);
  const std::optional<std::size_t> tick = simulation->tick_of_run();
  state_.simulator.SetResult(tick ? run.run().recording().ticks()[*tick].result : Status::kIdle);
  if (!tick) return run.playhead().GoToNow();
  run.playhead().GoToTick(*tick);
}

void SimulationEditor::Halt() {
  if (Simulation* simulation = GoOn()) simulation->Halt();
}

void SimulationEditor::Restart() {
  state_.simulator.Pause();
  if (Simulation* simulation = GoOn()) simulation->Restart();
  state_.simulator.SetResult(Status::kIdle);
}

void SimulationEditor::PlayAgain() {
  state_.simulator.Pause();
  if (Simulation* simulation = GoOn()) simulation->PlayAgain();
}

void SimulationEditor::ChangeSpeed(double factor) {
  state_.simulator.SetSpeed(state_.simulator.speed() * factor);
}

Outcome SimulationEditor::SetSeed(const std::string& text) {
  state_.simulator.Pause();
  Simulation* simulation = GoOn();
  const std::optional<std::uint64_t> seed = NumberIn(text, kLargestSeed);
  if (!seed && !text.empty()) return Problem{"a seed is a whole number"};
  if (!simulation) return {};
  state_.simulator.SetResult(Status::kIdle);
  if (!seed) {
    simulation->SetChance(std::nullopt);
    return {};
  }
  Diagnostics diagnostics;
  std::optional<RandomPlay> play = state_.simulator.ReadRandomPlay(diagnostics);
  if (!play) return Problem{FirstProblem(diagnostics)};
  simulation->SetChance(Chance{*seed, *std::move(play)});
  return {};
}

Outcome SimulationEditor::RunTicks(const std::string& text) {
  state_.simulator.Pause();
  Simulation* simulation = GoOn();
  const std::optional<std::uint64_t> ticks = NumberIn(text, kMostTicks);
  if (!ticks || *ticks == 0) return Problem{"a number from 1 to " + std::to_string(kMostTicks)};
  if (!simulation) return Problem{"there is no simulation"};
  state_.simulator.SetResult(Status::kRunning);
  for (std::uint64_t i = 0; i < *ticks && !state_.simulator.result(); ++i) {
    state_.simulator.SetResult(simulation->Tick(state_.simulator.period()));
  }
  return {};
}

Outcome SimulationEditor::RunOften(const std::string& text) {
  const std::optional<std::uint64_t> runs = NumberIn(text, kMostRuns);
  if (!runs || *runs == 0) return Problem{"a number from 1 to " + std::to_string(kMostRuns)};
  const Simulation* simulation = state_.simulator.get();
  if (!simulation) return Problem{"there is no simulation"};
  Diagnostics diagnostics;
  std::optional<RandomPlay> play = state_.simulator.ReadRandomPlay(diagnostics);
  if (!play) return Problem{FirstProblem(diagnostics)};
  ScenarioStep told = simulation->Told();
  RandomRunOptions options;
  options.seed = simulation->chance() ? simulation->chance()->seed : 1;
  options.play = *std::move(play);
  options.set = std::move(told.set);
  options.scripts = std::move(told.leaves);
  options.period = state_.simulator.period();
  state_.coverage.Start(simulation->program(), std::move(options), *runs);
  state_.run.tab = RunTab::kCoverage;
  state_.screen.tiles.run = true;
  if (!state_.run.heat) state_.run.heat = HeatMode::kTicks;
  return {};
}

void SimulationEditor::GoToFinding(const RandomFinding& finding) {
  state_.simulator.Pause();
  Simulation* simulation = GoOn();
  if (!simulation) return;
  simulation->PlayRun({finding.seed, state_.coverage.play()}, finding.tick,
                      state_.simulator.period());
  state_.Notify("seed " + std::to_string(finding.seed) + ", tick " + std::to_string(finding.tick),
                now_);
}

NodeIndex SimulationEditor::SelectedLeaf() const {
  const TreeView* view = state_.workspace.view();
  const NodeIndex selected = view ? view->selected_run_node() : kNoNode;
  if (!IsShown() || selected == kNoNode) return kNoNode;
  const RunView& run = *state_.workspace.run();
  if (!run.tree()) return kNoNode;
  // What is shown may be the tree before an edit.
  const std::string& path = run.tree()->description()->nodes[selected].path;
  const Simulation& simulation = *state_.simulator.get();
  for (NodeIndex node{0}; node < simulation.program()->nodes.size(); ++node) {
    if (simulation.program()->Path(node) != path) continue;
    return simulation.ScriptOf(node) ? node : kNoNode;
  }
  return kNoNode;
}

void SimulationEditor::SetLeaf(NodeIndex leaf, const MockScript& script) {
  Simulation* simulation = AtPlayhead();
  if (simulation) simulation->SetScript(leaf, script);
}

void SimulationEditor::Finish(Status status) {
  const NodeIndex leaf = SelectedLeaf();
  if (leaf == kNoNode) return state_.Notify("Select a leaf first", now_, true);
  MockScript script;
  script.results = {status};
  SetLeaf(leaf, script);
  if (!state_.simulator.is_playing()) Tick();
}

Outcome SimulationEditor::SetScript(const std::string& text) {
  const NodeIndex leaf = SelectedLeaf();
  if (leaf == kNoNode) return Problem{"select a leaf first"};
  const Expected<MockScript> script = ParseScript(text);
  if (!script) return Problem{script.problem()};
  SetLeaf(leaf, *script);
  return {};
}

Outcome SimulationEditor::SetKey(const std::string& assignment) {
  const std::size_t sign = assignment.find('=');
  if (sign == std::string::npos) return Problem{"write it like this: battery_level = 0.2"};
  Simulation* simulation = AtPlayhead();
  if (!simulation) return Problem{"there is no simulation"};
  return simulation->SetKey(Trimmed(assignment.substr(0, sign)),
                            Trimmed(assignment.substr(sign + 1)));
}

Outcome SimulationEditor::SaveAsScenario(const std::string& name) {
  Simulation* simulation = AtPlayhead();
  if (!simulation || name.empty()) return Problem{"a name is needed"};
  if (simulation->ticks() == 0) return Problem{"nothing has happened yet"};
  Diagnostics diagnostics;
  const std::string path =
      SaveScenario(simulation->Record(name), state_.simulator.path(), state_.simulator.tree_id(),
                   state_.workspace.model_files(), "", diagnostics);
  if (path.empty()) return Problem{FirstProblem(diagnostics)};
  state_.Notify("\"" + name + "\" is a test in " + NameOf(path), now_);
  state_.screen.tiles.tests = true;
  state_.tests.Look({state_.simulator.path()});
  return {};
}

Outcome SimulationEditor::SaveAsRecord(const std::string& path) {
  Simulation* simulation = AtPlayhead();
  if (!simulation || path.empty()) return Problem{"a path is needed"};
  Diagnostics diagnostics;
  if (!WriteFile(path, simulation->ToRecord(), diagnostics))
    return Problem{FirstProblem(diagnostics)};
  state_.Notify("recorded in " + NameOf(path), now_);
  return {};
}

void SimulationEditor::RunScenarios() {
  state_.screen.tiles.tests = true;
  std::vector<std::string> paths;
  for (const OpenFile& file : state_.workspace.files()) paths.push_back(file.path);
  state_.tests.Look(paths);
  state_.tests.Run(state_.workspace.project(), "*");
  const std::size_t all = state_.tests.all().size();
  const std::size_t passed = state_.tests.Count(ScenarioTest::State::kPassed);
  if (all == 0) return state_.Notify("there are no *.test.json beside the open files", now_, true);
  state_.Notify(std::to_string(passed) + " of " + std::to_string(all) + " tests passed", now_,
                passed != all);
}

void SimulationEditor::ShowTest(const ScenarioTest& test) {
  if (!test.tree_file.empty()) state_.services.open_file(test.tree_file);
}

}  // namespace coppice::editor
