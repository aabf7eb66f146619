#include "editor/simulation/simulated_tree.h"

#include <utility>

#include "bt_core/data/value_bytes.h"
#include "bt_core/testing/default_leaves.h"
#include "bt_core/testing/random_runs.h"

namespace coppice::editor {
namespace {

// The same for all trees of this program: they are told as one run.
const RunId& RunOfThisProgram() {
  static const RunId id = MakeRunId();
  return id;
}

}  // namespace

std::vector<PlacedRule> LeavesOf(const Program& program, const std::optional<Chance>& chance) {
  return chance ? RandomLeaves(program, chance->play.leaves) : DefaultLeaves(program);
}

SimulatedTree::SimulatedTree(std::shared_ptr<const Program> program, std::optional<Chance> chance,
                             HistoryHandler* handler)
    : program_(std::move(program)),
      chance_(std::move(chance)),
      player_(*program_, LeavesOf(*program_, chance_), chance_ ? chance_->seed : 0),
      handler_(handler) {
  SetKeysByChance();
  player_.tree().executor().AddSink(this);
  const HistoryState begin = StateNow(HistoryState::Cause::kBegin);
  follower_.emplace(ShapeOf(DescribeTree(*program_, {})), begin);
  if (!handler_) return;
  Describe(*handler_);
  handler_->OnState(begin);
}

SimulatedTree::~SimulatedTree() { player_.tree().executor().RemoveSink(this); }

void SimulatedTree::SetKeysByChance() {
  if (!chance_) return;
  ScenarioStep before_the_first_tick;
  before_the_first_tick.ticks = 0;
  before_the_first_tick.set = ChosenKeys(chance_->play.set, chance_->seed);
  player_.Play(before_the_first_tick);
}

void SimulatedTree::Reload(std::shared_ptr<const Program> program) {
  program_ = std::move(program);
  player_.Reload(*program_, LeavesOf(*program_, chance_));
}

void SimulatedTree::TellTo(HistoryHandler& handler, bool knows_tree) {
  handler_ = &handler;
  if (!knows_tree) Describe(handler);
  const bool begins = player_.tree().executor().ticks() == 0;
  handler.OnState(
      follower_->State(begins ? HistoryState::Cause::kBegin : HistoryState::Cause::kJump));
}

void SimulatedTree::OnTick(const TickEvents& events) {
  follower_->Apply(events);
  if (handler_) handler_->OnTick(events);
}

void SimulatedTree::OnJump(const Executor&) {
  const HistoryState state = StateNow(HistoryState::Cause::kJump);
  follower_.emplace(ShapeOf(DescribeTree(*program_, {})), state);
  if (!handler_) return;
  Describe(*handler_);
  handler_->OnState(state);
}

HistoryState SimulatedTree::StateNow(HistoryState::Cause cause) const {
  const Executor& executor = player_.tree().executor();
  HistoryState state;
  state.cause = cause;
  state.tick = executor.ticks();
  state.time = now();
  state.statuses = executor.statuses();
  for (const Slot& slot : executor.blackboard()) {
    AppendValueBytes(slot.value, state.values.emplace_back());
  }
  return state;
}

void SimulatedTree::Describe(HistoryHandler& handler) const {
  RunInfo info = BeginRun(player_.clock());
  info.run = RunOfThisProgram();
  info.metadata = {{"source", "simulation"}};
  handler.OnTree(DescribeTree(*program_, std::move(info)));
}

}  // namespace coppice::editor
