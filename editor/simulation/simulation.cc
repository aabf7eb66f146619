// What was done is a tree of moves, each of which knows the one before it: going back and doing
// something else begins another branch. No state of the engine is kept with them; to go back is to
// play the moves on the way from the first one again. So whatever can be simulated can be gone back
// over, and saved as a test that does the same.
#include "editor/simulation/simulation.h"

#include <algorithm>
#include <map>
#include <utility>

#include "bt_core/analysis/formats/write_record.h"
#include "bt_core/testing/random_runs.h"
#include "bt_core/testing/scenario_writer.h"

namespace coppice::editor {

Simulation::Simulation(std::shared_ptr<const Program> program, HistoryHandler& run) : run_(run) {
  Begin(std::move(program), std::nullopt);
}

void Simulation::Begin(std::shared_ptr<const Program> program, std::optional<Chance> chance) {
  next_ = {};
  moves_.push_back({kNone, program, chance, {}});
  HistoryHandler* const teller = this;
  tree_ = std::make_unique<SimulatedTree>(std::move(program), std::move(chance), teller);
  StandAtEnd(moves_.size() - 1);
}

void Simulation::OnTick(const TickEvents& events) {
  move_of_tick_.push_back(at_);
  run_.OnTick(events);
}

std::string Simulation::ValueOf(const std::string& key) const {
  std::string hint;
  const SlotIndex slot = FindKey(*program(), key, hint);
  if (slot == kNoSlot) return {};
  const Value& value = tree_->player().tree().executor().blackboard()[slot].value;
  return value.has_value() ? value.Print() : std::string();
}

std::vector<std::string> Simulation::Keys() const {
  std::vector<std::string> keys;
  for (SlotIndex slot{0}; slot < program()->layout.slots.size(); ++slot) {
    std::string key = KeyPathOf(*program(), slot);
    if (!key.empty()) keys.push_back(std::move(key));
  }
  return keys;
}

bool Simulation::SetScript(NodeIndex node, const MockScript& script) {
  if (!tree_->player().tree().ScriptOf(node)) return false;
  const std::string pattern = PatternOf(*program(), node);
  for (PlacedRule& placed : next_.leaves) {
    if (placed.rule.pattern != pattern) continue;
    placed.rule.script = script;
    return true;
  }
  next_.leaves.push_back({{}, {pattern, script}});
  return true;
}

const MockScript* Simulation::ScriptOf(NodeIndex node) const {
  const std::string pattern = PatternOf(*program(), node);
  for (const PlacedRule& placed : next_.leaves) {
    if (placed.rule.pattern == pattern) return &placed.rule.script;
  }
  return tree_->player().tree().ScriptOf(node);
}

Outcome Simulation::SetKey(const std::string& key, const std::string& text) {
  return SetKey({{}, key, text, KindOfText(text)});
}

Outcome Simulation::SetKey(const KeyValue& value) {
  if (Outcome checked = CheckKeyValue(*program(), value); !checked) return checked;
  const auto same = [&](const KeyValue& other) { return other.key == value.key; };
  next_.set.erase(std::remove_if(next_.set.begin(), next_.set.end(), same), next_.set.end());
  next_.set.push_back(value);
  return {};
}

Status Simulation::Tick(Duration after) {
  ScenarioStep step = std::exchange(next_, {});
  step.advance = after;
  return Play(std::move(step)).status;
}

Status Simulation::TickUntilChange(Duration period, Duration limit) {
  Status status = Status::kIdle;
  for (Duration passed{0}; passed < limit; passed += period) {
    const std::vector<Status> before = state().statuses();
    status = Tick(period);
    if (state().statuses() != before) break;
  }
  return status;
}

void Simulation::Halt() {
  ScenarioStep step = std::exchange(next_, {});
  step.halt = true;
  Play(std::move(step));
}

StepOutcome Simulation::Play(ScenarioStep step) {
  TellPlace();
  moves_.push_back({at_, nullptr, std::nullopt, std::move(step)});
  StandAtEnd(moves_.size() - 1);
  return tree_->Play(moves_[at_].step);
}

void Simulation::Reload(std::shared_ptr<const Program> program) {
  const bool is_at_end = at_ == told_;
  moves_.push_back({at_, program, std::nullopt, {}});
  at_ = moves_.size() - 1;
  tree_->Reload(std::move(program));
  if (is_at_end) StandAtEnd(at_);
}

bool Simulation::GoTo(std::size_t tick) {
  if (tick >= move_of_tick_.size()) return false;
  GoToMove(move_of_tick_[tick]);
  return true;
}

bool Simulation::Back() {
  const std::size_t move = WithoutReloads(at_);
  if (moves_[move].before == kNone) return false;
  GoToMove(moves_[move].before);
  if (!tick_of_run()) TellPlace();
  return true;
}

std::size_t Simulation::WithoutReloads(std::size_t move) const {
  while (moves_[move].before != kNone && moves_[move].program) move = moves_[move].before;
  return move;
}

std::optional<std::size_t> Simulation::tick_of_run() const {
  const auto last = std::find(move_of_tick_.rbegin(), move_of_tick_.rend(), WithoutReloads(at_));
  if (last == move_of_tick_.rend()) return std::nullopt;
  return static_cast<std::size_t>(move_of_tick_.rend() - last) - 1;
}

void Simulation::GoToMove(std::size_t move) {
  if (WithoutReloads(move) == WithoutReloads(at_)) return;
  next_ = {};
  const std::shared_ptr<const Program> present = program();
  tree_ = Replay(move, nullptr);
  at_ = move;
  if (program() != present) Reload(present);
}

void Simulation::TellPlace() {
  if (at_ == told_) return;
  tree_->TellTo(*this, program() == told_program_);
  StandAtEnd(at_);
}

void Simulation::StandAtEnd(std::size_t move) {
  at_ = told_ = move;
  told_program_ = program();
}

std::unique_ptr<SimulatedTree> Simulation::Replay(std::size_t to, HistoryHandler* handler) const {
  std::unique_ptr<SimulatedTree> tree;
  for (const std::size_t i : Way(to)) {
    const Move& move = moves_[i];
    if (!tree) {
      tree = std::make_unique<SimulatedTree>(move.program, move.chance, handler);
    } else if (move.program) {
      tree->Reload(move.program);
    } else {
      tree->Play(move.step);
    }
  }
  return tree;
}

void Simulation::Restart() { Begin(program(), chance()); }

void Simulation::SetChance(std::optional<Chance> chance) { Begin(program(), std::move(chance)); }

void Simulation::PlayRun(Chance chance, std::uint64_t ticks, Duration period) {
  ScenarioStep told = Told();
  Begin(program(), std::move(chance));
  next_ = std::move(told);
  Duration wait{0};
  for (std::uint64_t i = 0; i < ticks; ++i) {
    Tick(wait);
    wait = tree_->player().tree().executor().next_tick() > tree_->now() ? period : Duration(0);
  }
}

ScenarioStep Simulation::Told() const {
  std::vector<ScenarioStep> steps = Steps();
  steps.push_back(next_);
  std::map<std::string, PlacedRule> leaves;
  std::map<std::string, KeyValue> keys;
  for (const ScenarioStep& step : steps) {
    for (const PlacedRule& placed : step.leaves) leaves[placed.rule.pattern] = placed;
    for (const KeyValue& value : step.set) keys[value.key] = value;
  }
  ScenarioStep told;
  for (const auto& [pattern, placed] : leaves) told.leaves.push_back(placed);
  for (const auto& [key, value] : keys) told.set.push_back(value);
  return told;
}

void Simulation::PlayAgain() {
  const std::vector<ScenarioStep> steps = Steps();
  Restart();
  for (const ScenarioStep& step : steps) Play(step);
}

std::vector<std::size_t> Simulation::Way(std::size_t to) const {
  std::vector<std::size_t> way;
  for (std::size_t move = to; move != kNone; move = moves_[move].before) way.push_back(move);
  std::reverse(way.begin(), way.end());
  return way;
}

std::vector<ScenarioStep> Simulation::Steps() const {
  std::vector<ScenarioStep> steps;
  for (const std::size_t move : Way(at_)) {
    if (!moves_[move].program) steps.push_back(moves_[move].step);
  }
  return steps;
}

// A test has no other chance than that of its leaves.
std::vector<ScenarioStep> Simulation::StepsWithChosenKeys() const {
  std::vector<ScenarioStep> steps = Steps();
  if (!chance() || steps.empty()) return steps;
  std::vector<KeyValue>& set = steps.front().set;
  for (KeyValue& chosen : ChosenKeys(chance()->play.set, chance()->seed)) {
    const bool is_told = std::any_of(set.begin(), set.end(),
                                     [&](const KeyValue& told) { return told.key == chosen.key; });
    if (!is_told) set.push_back(std::move(chosen));
  }
  return steps;
}

Scenario Simulation::Record(std::string name) const {
  std::vector<PlacedRule> leaves = LeavesOf(*program(), chance());
  const std::vector<std::string> unused = tree_->player().tree().UnusedPatterns();
  const auto fits_none = [&](const PlacedRule& placed) {
    return std::find(unused.begin(), unused.end(), placed.rule.pattern) != unused.end();
  };
  leaves.erase(std::remove_if(leaves.begin(), leaves.end(), fits_none), leaves.end());
  return RecordScenario(*program(), leaves, StepsWithChosenKeys(), std::move(name),
                        chance() ? chance()->seed : 0);
}

std::string Simulation::ToRecord() const {
  Recording recording;
  Replay(at_, &recording);
  return coppice::ToRecord(recording);
}

}  // namespace coppice::editor
