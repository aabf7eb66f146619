#include "bt_core/live/debug/debugger_core.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace coppice {

Debugger::Core::Core(Executor& executor, DebuggerOptions options)
    : executor_(executor),
      inbox_(*executor.inbox()),
      options_(std::move(options)),
      table_(executor.shared_program()) {
  executor_.RunCalls();  // the debugger before this one may lie there
  executor_.SetHooks(this);
}

void Debugger::Core::Close() {
  Lock lock(mutex_);
  is_closed_ = true;
  for (const HookTable::Entry& entry : std::vector<HookTable::Entry>(table_.entries())) {
    table_.Remove(entry.info.id);
  }
  ChangedHooks();
  Resume();
  told_.wait(lock, [this] { return !is_telling_; });
}

// ---- The ticking thread

void Debugger::Core::BeforeTick() {
  if (!attention_.load(std::memory_order_acquire)) return;
  const std::shared_ptr<Core> alive = shared_from_this();  // a call of the inbox may detach it
  Lock lock(mutex_);
  if (mode_ != Mode::kRun) Stand(lock, {DebugStop::Where::kBetweenTicks});
  HandOver();
}

void Debugger::Core::OnReload() {
  const Lock lock(mutex_);
  table_.SetProgram(executor_.shared_program());
  executor_.SetHooks(this);
  has_new_hooks_ = true;
  HandOver();
}

// The nodes are chosen anew only between ticks, but for those of a step.
void Debugger::Core::HandOver() {
  const bool all = mode_ == Mode::kStopBeforeNode;
  if (has_new_hooks_ || all != stops_at_all_nodes_) {
    std::vector<NodeIndex> nodes = table_.Nodes();
    if (all) {
      nodes.resize(table_.program()->nodes.size());
      for (NodeIndex i{0}; i < nodes.size(); ++i) nodes[i] = i;
    }
    executor_.SetHooks(this, nodes);
    stops_at_all_nodes_ = all;
    has_new_hooks_ = false;
  }
  attention_.store(mode_ != Mode::kRun, std::memory_order_relaxed);
}

std::optional<Status> Debugger::Core::Before(NodeIndex node) {
  Lock lock(mutex_);
  const bool steps = mode_ == Mode::kStopBeforeNode;
  if (steps) {
    const auto forced = Stand(lock, {DebugStop::Where::kBefore, node});
    if (forced) return forced;
  }
  return ActAt(lock, node, HookPosition::kBefore, Status::kIdle, steps);
}

std::optional<Status> Debugger::Core::After(NodeIndex node, Status result) {
  Lock lock(mutex_);
  return ActAt(lock, node, HookPosition::kAfter, result, false);
}

std::optional<Status> Debugger::Core::ActAt(Lock& lock, NodeIndex node, HookPosition position,
                                            Status result, bool has_stood) {
  const auto where =
      position == HookPosition::kBefore ? DebugStop::Where::kBefore : DebugStop::Where::kAfter;
  for (const HookId id : table_.At(node, position)) {
    HookTable::Entry* const entry = table_.Find(id);  // it may have gone during a stop
    if (!entry) continue;
    if (entry->info.hook.action == HookAction::kDelay) {
      bool is_due = false;
      const auto status = ContinueDelay(*entry, node, is_due);
      if (status) return status;
      if (!is_due) continue;
    }
    if (!CountHit(*entry)) continue;
    if (entry->info.hook.action == HookAction::kStop && has_stood) continue;
    const auto decided = Act(lock, id, {where, node, result, id});
    if (decided) return decided;
  }
  return std::nullopt;
}

bool Debugger::Core::CountHit(HookTable::Entry& entry) const {
  HookInfo& info = entry.info;
  if (entry.condition) {
    try {
      // It writes nothing: CompileCondition has seen to that.
      if (!entry.condition->Test(const_cast<Blackboard&>(executor_.blackboard()))) return false;
      info.problem.clear();
    } catch (const ScriptError& error) {
      info.problem = error.what();
      return false;
    }
  }
  ++info.hits;
  return info.hits >= info.hook.from_hit;
}

std::optional<Status> Debugger::Core::Act(Lock& lock, HookId id, const DebugStop& stop) {
  HookTable::Entry& entry = *table_.Find(id);
  ++entry.info.acted;
  if (entry.info.hook.action == HookAction::kStop) {
    const auto forced = Stand(lock, stop);
    RemoveIfUsedUp(id);
    return forced;
  }
  DebugStop decided = stop;
  decided.result = entry.info.hook.status;
  if (entry.info.hook.action == HookAction::kDelay) {
    BeginDelay(entry, stop.node);
    decided.result = Status::kRunning;
  } else {
    RemoveIfUsedUp(id);
  }
  Tell(lock, DebugEvent::Kind::kReplaced, decided);
  return decided.result;
}

void Debugger::Core::RemoveIfUsedUp(HookId id) {
  const HookTable::Entry* const entry = table_.Find(id);
  if (!entry || entry->info.hook.times == 0 || entry->info.acted < entry->info.hook.times) return;
  table_.Remove(id);
  ChangedHooks();
}

// A delay that has begun goes on; `is_due`: the node is about to begin, so one may begin.
std::optional<Status> Debugger::Core::ContinueDelay(HookTable::Entry& entry, NodeIndex node,
                                                    bool& is_due) {
  auto& delayed = entry.delayed;
  const auto at = std::find_if(delayed.begin(), delayed.end(),
                               [node](const HookTable::Delayed& d) { return d.node == node; });
  const bool is_running = executor_.status(node) == Status::kRunning;
  is_due = !is_running;
  if (at == delayed.end()) return std::nullopt;
  if (is_running && executor_.now() < at->until) {
    executor_.WakeAt(at->until);
    return Status::kRunning;
  }
  delayed.erase(at);  // over, or halted meanwhile
  if (is_running) RemoveIfUsedUp(entry.info.id);
  return std::nullopt;
}

void Debugger::Core::BeginDelay(HookTable::Entry& entry, NodeIndex node) {
  const Time until = executor_.now() + entry.info.hook.delay;
  entry.delayed.push_back({node, until});
  executor_.WakeAt(until);
}

// The tree stands here until it is let go on; returns what is forced on the node then.
std::optional<Status> Debugger::Core::Stand(Lock& lock, DebugStop stop) {
  const bool between_ticks = stop.where == DebugStop::Where::kBetweenTicks;
  stop.tick = executor_.ticks();
  if (IsOver()) return std::nullopt;
  if (Outcome permission = Permission(); !permission) {
    mode_ = Mode::kRun;
    Tell(lock, DebugEvent::Kind::kRefused, stop, std::move(permission).problem());
    return std::nullopt;
  }
  stop_ = stop;
  mode_ = Mode::kRun;
  resumes_ = false;
  forced_.reset();
  if (!between_ticks) executor_.ReportSoFar();
  Tell(lock, DebugEvent::Kind::kStopped, stop);
  WaitForRelease(lock, between_ticks);
  stop_ = {};
  if (mode_ == Mode::kStopBeforeNode && !between_ticks) HandOver();
  Tell(lock, DebugEvent::Kind::kResumed, stop);
  inbox_.wake_up().Notify();  // what woke this wait may have been for another one
  return between_ticks ? std::nullopt : std::exchange(forced_, std::nullopt);
}

// Between ticks the calls of other threads are served, as they are in the pauses of the tree.
void Debugger::Core::WaitForRelease(Lock& lock, bool between_ticks) {
  while (!resumes_ && !IsOver()) {
    lock.unlock();
    inbox_.wake_up().WaitFor(std::chrono::nanoseconds::max());
    if (between_ticks) executor_.RunCalls();
    lock.lock();
  }
}

bool Debugger::Core::IsOver() const { return is_closed_ || inbox_.is_ending(); }

void Debugger::Core::Tell(Lock& lock, DebugEvent::Kind kind, const DebugStop& stop,
                          std::string reason) {
  if (!options_.on_event || is_closed_) return;
  is_telling_ = true;
  lock.unlock();
  options_.on_event({kind, stop, std::move(reason)});
  lock.lock();
  is_telling_ = false;
  told_.notify_all();
}

// ---- Any other thread

Expected<HookAnswer> Debugger::Core::Add(const Hook& hook, OwnerId owner) {
  if (Outcome permission = Permission(); !permission) return Problem{permission.problem()};
  const Lock lock(mutex_);
  if (is_closed_) return Problem{"the debugger has ended"};
  Expected<HookAnswer> answer = table_.Add(hook, owner);
  ChangedHooks();
  return answer;
}

Expected<HookAnswer> Debugger::Core::Change(HookId id, const Hook& hook) {
  if (Outcome permission = Permission(); !permission) return Problem{permission.problem()};
  const Lock lock(mutex_);
  Expected<HookAnswer> answer = table_.Change(id, hook);
  if (answer) LeaveHook(id);
  ChangedHooks();
  return answer;
}

bool Debugger::Core::Remove(HookId id) {
  const Lock lock(mutex_);
  if (!table_.Remove(id)) return false;
  LeaveHook(id);
  ChangedHooks();
  return true;
}

bool Debugger::Core::SetEnabled(HookId id, bool enabled) {
  const Lock lock(mutex_);
  HookTable::Entry* const entry = table_.Find(id);
  if (!entry) return false;
  entry->info.hook.enabled = enabled;
  if (!enabled) LeaveHook(id);
  return true;
}

void Debugger::Core::RemoveAllOf(OwnerId owner) {
  const Lock lock(mutex_);
  for (const HookId id : table_.IdsOf(owner)) {
    table_.Remove(id);
    LeaveHook(id);
  }
  ChangedHooks();
}

void Debugger::Core::SetAllEnabledOf(OwnerId owner, bool enabled) {
  const Lock lock(mutex_);
  for (const HookId id : table_.IdsOf(owner)) {
    table_.Find(id)->info.hook.enabled = enabled;
    if (!enabled) LeaveHook(id);
  }
}

void Debugger::Core::Release(OwnerId owner) {
  RemoveAllOf(owner);
  const Lock lock(mutex_);
  if (controller_ != owner) return;
  const bool is_its_stop = stop_.where != DebugStop::Where::kNowhere && stop_.hook == kNoHook;
  mode_ = Mode::kRun;
  if (is_its_stop) Resume();
}

Outcome Debugger::Core::Pause(OwnerId owner) {
  if (Outcome permission = Permission(); !permission) return permission;
  const Lock lock(mutex_);
  if (stop_.where != DebugStop::Where::kNowhere) return {};
  return SetMode(Mode::kStopBeforeTick, owner);
}

Outcome Debugger::Core::StepNode(OwnerId owner) {
  if (Outcome permission = Permission(); !permission) return permission;
  const Lock lock(mutex_);
  return SetMode(Mode::kStopBeforeNode, owner);
}

Outcome Debugger::Core::StepTick(OwnerId owner) {
  if (Outcome permission = Permission(); !permission) return permission;
  const Lock lock(mutex_);
  return SetMode(Mode::kStopBeforeTick, owner);
}

// A tree that waits for an event is ticked, so that it comes to the stop.
Outcome Debugger::Core::SetMode(Mode mode, OwnerId owner) {
  if (is_closed_) return Problem{"the debugger has ended"};
  mode_ = mode;
  controller_ = owner;
  attention_.store(true, std::memory_order_release);
  inbox_.RequestTick();
  if (stop_.where != DebugStop::Where::kNowhere) Resume();
  return {};
}

void Debugger::Core::Continue(std::optional<Status> result) {
  const Lock lock(mutex_);
  mode_ = Mode::kRun;
  if (stop_.where == DebugStop::Where::kNowhere) return;
  if (result && *result != Status::kIdle) forced_ = result;
  Resume();
}

std::vector<HookInfo> Debugger::Core::hooks() const {
  const Lock lock(mutex_);
  std::vector<HookInfo> infos;
  for (const HookTable::Entry& entry : table_.entries()) infos.push_back(entry.info);
  return infos;
}

std::optional<HookInfo> Debugger::Core::Find(HookId id) const {
  const Lock lock(mutex_);
  const HookTable::Entry* const entry = table_.Find(id);
  return entry ? std::optional<HookInfo>(entry->info) : std::nullopt;
}

DebugStop Debugger::Core::where() const {
  const Lock lock(mutex_);
  return stop_;
}

bool Debugger::Core::is_pausing() const {
  const Lock lock(mutex_);
  return stop_.where != DebugStop::Where::kNowhere || mode_ != Mode::kRun;
}

// The ticking thread takes them over before the next tick.
void Debugger::Core::ChangedHooks() {
  has_new_hooks_ = true;
  attention_.store(true, std::memory_order_release);
}

// A tree that stands at this hook goes on.
void Debugger::Core::LeaveHook(HookId id) {
  if (stop_.where != DebugStop::Where::kNowhere && stop_.hook == id) Resume();
}

void Debugger::Core::Resume() {
  resumes_ = true;
  inbox_.wake_up().Notify();
}

}  // namespace coppice
