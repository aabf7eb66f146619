#include "bt_core/compat/tree_run.h"

#include <algorithm>
#include <utility>

namespace BT::internal {

using coppice::NodeIndex;
using coppice::Status;

namespace {

NodeStatus FromEngine(Status status) { return static_cast<NodeStatus>(status); }
Status ToEngine(NodeStatus status) { return static_cast<Status>(status); }

// Of nodes without tree: nobody ticks them.
Gate& NoGate() {
  static Gate gate;
  return gate;
}

}  // namespace

TreeRun::TreeRun(std::shared_ptr<const coppice::Program> program)
    : executor_(std::make_unique<coppice::Executor>(
          std::move(program), clock_,
          coppice::ExecutorOptions{coppice::ExceptionPolicy::kRethrow})),
      wake_up_(std::make_shared<WakeUpSignal>(executor_->inbox())) {}

TreeRun::~TreeRun() {
  for (const std::shared_ptr<Cell>& cell : own_) {
    const GateLock lock(gate_);
    cell->own.value = std::move(cell->slot->value);
    cell->own.writes = cell->slot->writes;
    cell->own.stamp = cell->slot->stamp;
    cell->slot = &cell->own;
    cell->gate = &cell->own_gate;
    cell->now = nullptr;
    cell->demanded = nullptr;
  }
  for (const TreeNode::Ptr& node : nodes_) {
    node->run_ = nullptr;
    node->gate_ = &NoGate();
    node->ports_.Clear();
  }
}

void TreeRun::Attach(const std::shared_ptr<Cell>& cell, coppice::SlotIndex index) {
  if (cell->slot != &cell->own) {
    shared_.push_back({cell, index});
    return;
  }
  coppice::Slot& slot = executor_->blackboard()[index];
  const coppice::Type* const type = executor_->program().layout.slots[index].type;
  if (cell->own.value.has_value()) {
    if (type && cell->own.value.type() != type) {
      coppice::Value converted;
      if (converted.Parse(*type, cell->own.value.Print())) cell->own.value = std::move(converted);
    }
    if (!type || cell->own.value.type() == type) slot.value = std::move(cell->own.value);
  }
  slot.writes = cell->own.writes;
  slot.stamp = cell->own.stamp;
  cell->slot = &slot;
  cell->gate = &gate_;
  cell->now = &executor_->blackboard().now();
  cell->demanded = type;
  own_.push_back(cell);
}

void TreeRun::Add(TreeNode::Ptr node, std::vector<PortLink> links) {
  node->run_ = this;
  node->gate_ = &gate_;
  node->index_ = static_cast<std::uint32_t>(nodes_.size());
  node->ports_.Fill(std::move(links));
  node->FindScripts();
  nodes_.push_back(std::move(node));
}

NodeStatus TreeRun::Tick() {
  RefuseFromWithin("ticked");
  if (calls_changed_) ChooseCalled();
  if (!shared_.empty()) TakeShared();
  Status result;
  try {
    const OpenGate open(gate_);
    result = executor_->Tick();
  } catch (const coppice::TickError& error) {
    if (is_watched_) tick_ended_.notify();
    RethrowOf(error.node);
  }
  if (is_watched_) tick_ended_.notify();
  if (!shared_.empty()) GiveShared();
  return FromEngine(result);
}

// Called while a TickError is being handled.
void TreeRun::RethrowOf(NodeIndex index) {
  const TreeNode& node = *nodes_[index];
  const TickBacktraceEntry entry{node.name(), node.fullPath(), node.registrationName()};
  try {
    try {
      throw;
    } catch (const coppice::TickError& error) {
      std::rethrow_if_nested(error);
      throw;
    }
  } catch (const NodeExecutionError&) {
    throw;
  } catch (const std::exception& error) {
    throw NodeExecutionError(entry, error.what());
  }
}

void TreeRun::Halt() {
  RefuseFromWithin("halted");
  {
    const OpenGate open(gate_);
    executor_->Halt();
    if (is_watched_ && !nodes_.empty()) ShowIdle(0);
  }
  if (is_watched_) tick_ended_.notify();
}

// It would wait for itself.
void TreeRun::RefuseFromWithin(const char* what) const {
  if (!gate_.is_open() && halting_ != pthread_self()) return;
  throw LogicError("A tree can not be ", what,
                   " by one of its own nodes, nor by who watches one: return a status");
}

// What another tree's slot holds is copied, one lock at a time.
void TreeRun::TakeShared() {
  for (Shared& shared : shared_) {
    coppice::Value value;
    {
      const GateLock lock(*shared.cell->gate);
      if (shared.cell->slot->writes == shared.writes_there) continue;
      shared.writes_there = shared.cell->slot->writes;
      value = shared.cell->slot->value;
    }
    const GateLock lock(gate_);
    coppice::Slot& slot = executor_->blackboard()[shared.slot];
    slot.value = std::move(value);
    slot.CountWrite(clock_.Now());
    shared.writes_here = slot.writes;
  }
}

void TreeRun::GiveShared() {
  for (Shared& shared : shared_) {
    coppice::Value value;
    {
      const GateLock lock(gate_);
      const coppice::Slot& slot = executor_->blackboard()[shared.slot];
      if (slot.writes == shared.writes_here) continue;
      shared.writes_here = slot.writes;
      value = slot.value;
    }
    const GateLock lock(*shared.cell->gate);
    shared.cell->slot->value = std::move(value);
    CountWrite(*shared.cell);
    shared.writes_there = shared.cell->slot->writes;
  }
}

NodeStatus TreeRun::TickChild(const TreeNode& node) {
  return FromEngine(executor_->TickChild(static_cast<NodeIndex>(node.index_)));
}

void TreeRun::HaltChild(const TreeNode& node) {
  std::optional<OpenGate> open;
  if (!gate_.is_open()) open.emplace(gate_);  // from a halt() of the user's
  executor_->HaltChild(static_cast<NodeIndex>(node.index_));
  if (is_watched_) ShowIdle(node.index_);
}

bool TreeRun::is_child_of_user(const TreeNode& node) const {
  const coppice::Program& program = executor_->program();
  const NodeIndex parent = program.info[node.index_].parent;
  return program.nodes[parent].type == coppice::NodeType::kUser;
}

// A user's node sees what it did to its children; for the others it holds what the executor says.
NodeStatus TreeRun::StatusOf(const TreeNode& node) const {
  const auto index = static_cast<NodeIndex>(node.index_);
  if (is_child_of_user(node)) return FromEngine(executor_->StatusOfChild(index));
  return FromEngine(executor_->StatusOf(index));
}

// Nobody else may be kept from the blackboard meanwhile: the node may wait for a thread of its own.
void TreeRun::HaltNode(TreeNode& node) {
  struct ClosedGate {
    explicit ClosedGate(TreeRun& tree) : run(tree) {
      run.gate_.Leave();
      run.halting_ = pthread_self();
    }
    ~ClosedGate() {
      run.halting_ = pthread_t{};
      run.gate_.Enter();
    }
    TreeRun& run;
  };
  const ClosedGate closed(*this);
  node.HaltForEngine();
}

coppice::Duration TreeRun::UntilNextTick() {
  if (executor_->inbox()->TakeTickRequest()) return coppice::Duration::zero();
  const coppice::Time next = executor_->next_tick();
  if (next == coppice::kNever) return coppice::kForever;
  return std::max(next - clock_.Now(), coppice::Duration::zero());
}

// ---- Those who watch.

void TreeRun::ChooseCalled() {
  calls_changed_ = false;
  std::vector<NodeIndex> called;
  is_watched_ = false;
  for (const TreeNode::Ptr& node : nodes_) {
    if (!node->callbacks_) continue;
    called.push_back(static_cast<NodeIndex>(node->index_));
    is_watched_ |= node->callbacks_->changes.has_subscribers();
  }
  if (is_watched_) {  // what becomes of a node is seen when its parent has been ticked
    called.clear();
    for (NodeIndex node{0}; node < nodes_.size(); ++node) called.push_back(node);
  }
  executor_->SetHooks(called.empty() ? nullptr : this, called);
}

std::optional<Status> TreeRun::Before(NodeIndex index) {
  TreeNode& node = *nodes_[index];
  NodeCallbacks* const calls = node.callbacks_.get();
  const bool is_inner = node.type() != NodeType::ACTION && node.type() != NodeType::CONDITION;
  if (is_watched_ && is_inner) Show(node.index_, NodeStatus::RUNNING);
  if (!calls) return std::nullopt;
  if (calls->pre) {
    const NodeStatus status = calls->pre(node);
    if (status != NodeStatus::IDLE) {
      if (is_watched_) Show(node.index_, status);
      return ToEngine(status);
    }
  }
  if (calls->monitor) calls->start = std::chrono::steady_clock::now();
  return std::nullopt;
}

std::optional<Status> TreeRun::After(NodeIndex index, Status result) {
  TreeNode& node = *nodes_[index];
  NodeCallbacks* const calls = node.callbacks_.get();
  NodeStatus status = FromEngine(result);
  if (calls && calls->monitor) {
    const auto taken = std::chrono::steady_clock::now() - calls->start;
    calls->monitor(node, status, std::chrono::duration_cast<std::chrono::microseconds>(taken));
  }
  if (calls && calls->post) {
    const NodeStatus other = calls->post(node, status);
    if (isStatusCompleted(other)) status = other;
  }
  if (is_watched_) {
    ShowChildren(node.index_, isStatusCompleted(status));
    if (status != NodeStatus::SKIPPED) Show(node.index_, status);
  }
  return ToEngine(status);
}

void TreeRun::Show(std::uint32_t index, NodeStatus status) {
  TreeNode& node = *nodes_[index];
  NodeCallbacks* const calls = node.callbacks_.get();
  if (!calls || calls->shown == status) return;
  const NodeStatus before = std::exchange(calls->shown, status);
  calls->changes.notify(std::chrono::high_resolution_clock::now(), node, before, status);
}

// The children first.
void TreeRun::ShowIdle(std::uint32_t index) {
  ShowChildren(index, true);
  Show(index, NodeStatus::IDLE);
}

void TreeRun::ShowChildren(std::uint32_t index, bool are_idle) {
  const auto& nodes = executor_->program().nodes;
  const auto parent = static_cast<NodeIndex>(index);
  const NodeIndex end = nodes[parent].end;
  for (auto child = static_cast<NodeIndex>(index + 1); child < end; child = nodes[child].end) {
    const auto number = static_cast<std::uint32_t>(child);
    const bool is_behind = coppice::RunsOneChild(nodes[parent].type) &&
                           child > static_cast<NodeIndex>(executor_->memory(parent));
    const bool is_idle = are_idle || executor_->StatusOfChild(child) == Status::kIdle;
    if (is_idle || is_behind) ShowIdle(number);
  }
}

}  // namespace BT::internal
