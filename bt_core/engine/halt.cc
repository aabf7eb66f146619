// Halting, and leaves that need several ticks to stop.
#include <algorithm>
#include <exception>
#include <string>

#include "bt_core/engine/executor.h"
#include "bt_core/nodes/try_catch.h"

namespace coppice {
namespace {

// Ticked instead of a leaf that is asked to start before it has stopped.
Status WaitUntilStopped(UserNode&, Status) { return Status::kRunning; }

}  // namespace

void Executor::Halt() {
  HaltAll();
  wake_at_ = kNever;
  tick_again_ = false;
  reporter_.EndHalt(ticks_, now_);
}

void Executor::HaltAll() {
  Halt(kRootNode);
  for (NodeIndex i{0}; kept_ != 0 && i < statuses_.size(); ++i) {
    if (Keeps(i)) LetGo(i);
  }
}

void Executor::ResetChildren(NodeIndex node) {
  const NodeIndex end = nodes_[node].end;
  for (NodeIndex child = node + 1; child != end; child = nodes_[child].end) Halt(child);
}

// Makes the children idle that do not run; what they keep stays.
void Executor::LeaveChildren(NodeIndex node) {
  const NodeIndex end = nodes_[node].end;
  for (NodeIndex child = node + 1; child != end; child = nodes_[child].end) {
    const Status status = statuses_[child];
    if (status != Status::kIdle && status != Status::kRunning) MakeIdle(child);
  }
}

// SKIPPED does not end what a node has begun: a leaf that was RUNNING, or the rounds of a loop. It
// lies in the memory of a node that is not RUNNING, until the node is ticked again or its parent
// resets it.
void Executor::KeepSkipped() {
  if (statuses_[current_] != Status::kRunning) return;
  memory_[current_] = 1;
  ChangeKept(1);
}

bool Executor::ResumeSkipped() {
  if (!Keeps(current_)) return false;
  Resume(current_);
  return true;
}

void Executor::Resume(NodeIndex node) {
  if (!Keeps(node)) return;
  if (IsUserNode(nodes_[node].type)) memory_[node] = 0;
  statuses_[node] = Status::kRunning;
  ChangeKept(-1);
}

// A skipped node, and what was skipped below it, forgets what it keeps. The reset stands between
// what a leaf does when it is halted and what its hook does, as in HaltRunning: records are played
// by that. A SequenceWithMemory that is not RUNNING keeps its place, and with it what the children
// in front of that have begun.
void Executor::LetGo(NodeIndex node) {
  const bool has_kept = Keeps(node);
  if (has_kept) Forget(node);
  const bool keeps_place = nodes_[node].type == NodeType::kSequenceWithMemory;
  const NodeIndex end = keeps_place ? node + 1 : nodes_[node].end;
  for (NodeIndex child = node + 1; kept_ != 0 && child != end; child = nodes_[child].end) {
    LetGo(child);
  }
  if (has_kept && IsGuarded(node)) RunHaltedHook(node);
}

void Executor::Forget(NodeIndex node) {
  if (IsUserNode(nodes_[node].type)) HaltUser(node);
  memory_[node] = 0;
  ChangeKept(-1);
  MakeIdle(node);
}

// A node that waits until it has stopped has not.
bool Executor::HasBegun(NodeIndex user) {
  if (statuses_[user] != Status::kRunning) return Keeps(user);
  return UserOf(user).tick != &WaitUntilStopped;
}

void Executor::CountKept() {
  kept_ = 0;
  for (NodeIndex i{0}; i < statuses_.size(); ++i) kept_ += Keeps(i);
  ChangeKept(0);
}

void Executor::HaltRunning(NodeIndex node) {
  if (hooked_.StopPretending(node)) return MakeIdle(node);
  if (nodes_[node].type == NodeType::kTryCatch) CatchHaltOf(node);
  if (IsUserNode(nodes_[node].type)) HaltUser(node);
  memory_[node] = 0;
  MakeIdle(node);
  HaltDescendants(node);
  if (IsGuarded(node)) RunHaltedHook(node);
}

void Executor::CatchHaltOf(NodeIndex node) {
  try {
    CatchHalt(*this, node);
  } catch (const Abort&) {
    thrown_ = nullptr;  // what is halted anyway needs no end
  } catch (...) {
    AddExceptionMessage(node);
  }
}

// Flat, in document order. Only what runs has descendants that run, or skipped ones that keep
// something.
void Executor::HaltDescendants(NodeIndex node) {
  for (NodeIndex i = node + 1; i < nodes_[node].end;) {
    if (hooked_.StopPretending(i)) {
      MakeIdle(i);
      i = nodes_[i].end;
      continue;
    }
    const bool running = statuses_[i] == Status::kRunning;
    if (running && (IsGuarded(i) || nodes_[i].type == NodeType::kTryCatch)) {  // in its own way
      HaltRunning(i);
      i = nodes_[i].end;
      continue;
    }
    if (!running && kept_ != 0) LetGo(i);
    if (running && IsUserNode(nodes_[i].type)) HaltUser(i);
    memory_[i] = 0;
    if (statuses_[i] != Status::kIdle) MakeIdle(i);
    i = running ? i + 1 : nodes_[i].end;
  }
}

void Executor::HaltUser(NodeIndex node) {
  User& user = UserOf(node);
  if (user.tick == &WaitUntilStopped) return;  // it has not been started again yet
  current_ = node;
  try {
    user.node->Halt();
  } catch (const std::exception& error) {
    AddMessage(std::string("while halting: ") + error.what());
  } catch (...) {
    AddMessage("while halting: threw something that is not a std::exception");
  }
  reporter_.Writes(node);
}

void Executor::Drain(Duration limit) {
  User& user = UserOf(current_);
  drains_.push_back({current_, now_ + limit, user.tick, nullptr});
  user.tick = &WaitUntilStopped;
}

void Executor::ServeDrains() {
  now_ = clock_.Now();
  blackboard_.set_now(now_);
  wake_at_ = kNever;
  if (inbox_->has_messages()) ApplyInbox();  // the answer that a leaf waits for may be there
  const auto has_stopped = [this](Draining& drain) { return HasStopped(drain); };
  drains_.erase(std::remove_if(drains_.begin(), drains_.end(), has_stopped), drains_.end());
}

bool Executor::HasStopped(Draining& drain) {
  if (!drain.orphan) current_ = drain.node;
  bool stopped = true;
  try {
    stopped = (drain.orphan ? *drain.orphan : *UserOf(drain.node).node).HasStopped();
  } catch (const std::exception& error) {
    AddMessage(std::string("while stopping: ") + error.what());
  } catch (...) {
    AddMessage("while stopping: threw something that is not a std::exception");
  }
  if (!stopped && now_ < drain.until) {
    WakeAt(drain.until);
    return false;
  }
  if (!stopped) AddMessage("has not stopped in time and is given up");
  if (drain.orphan) return true;
  UserOf(drain.node).tick = drain.tick;
  // If the tree waits for it, the next tick starts it.
  if (statuses_[drain.node] == Status::kRunning) MakeIdle(drain.node);
  return true;
}

}  // namespace coppice
