#include "editor/simulation/simulated_tree.h"

#include <cctype>
#include <set>
#include <string>
#include <utility>

#include "bt_core/data/value_bytes.h"
#include "bt_core/testing/stand_in.h"

namespace coppice::editor {
namespace {

constexpr Duration kActionTime = std::chrono::seconds(1);

bool SoundsLikeACondition(const std::string& id) {
  for (const std::string verb : {"Is", "Has"}) {
    const bool fits = id.size() > verb.size() && id.compare(0, verb.size(), verb) == 0;
    if (fits && std::isupper(static_cast<unsigned char>(id[verb.size()]))) return true;
  }
  return false;
}

MockScript DefaultScript(const Registry::Entry& entry) {
  MockScript script;
  script.results = {Status::kSuccess};
  const bool is_condition = entry.manifest.category == NodeCategory::kCondition ||
                            SoundsLikeACondition(entry.manifest.id);
  if (!is_condition) script.duration = kActionTime;
  return script;
}

// The same for all trees of this program: they are told as one run.
const RunId& RunOfThisProgram() {
  static const RunId id = MakeRunId();
  return id;
}

}  // namespace

std::vector<PlacedRule> DefaultLeaves(const Program& program) {
  std::set<std::string> ids;
  for (const LeafRecord& record : program.leaves) ids.insert(program.Id(record.node));
  std::vector<PlacedRule> rules;
  for (const std::string& id : ids) {
    const Registry::Entry* entry = program.registry->Find(id);
    if (entry && IsStandIn(*entry)) rules.push_back({{}, {"<" + id + ">", DefaultScript(*entry)}});
  }
  return rules;
}

SimulatedTree::SimulatedTree(std::shared_ptr<const Program> program, HistoryHandler* handler)
    : program_(std::move(program)),
      player_(*program_, DefaultLeaves(*program_)),
      handler_(handler) {
  player_.tree().executor().AddSink(this);
  const HistoryState begin = StateNow(HistoryState::Cause::kBegin);
  follower_.emplace(ShapeOf(DescribeTree(*program_, {})), begin);
  if (!handler_) return;
  Describe(*handler_);
  handler_->OnState(begin);
}

SimulatedTree::~SimulatedTree() { player_.tree().executor().RemoveSink(this); }

void SimulatedTree::Reload(std::shared_ptr<const Program> program) {
  program_ = std::move(program);
  player_.Reload(*program_, DefaultLeaves(*program_));
}

void SimulatedTree::TellTo(HistoryHandler& handler, bool knows_tree) {
  handler_ = &handler;
  if (!knows_tree) Describe(handler);
  handler.OnState(follower_->State(HistoryState::Cause::kJump));
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
