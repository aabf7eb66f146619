// Runs a Program: the mutable half of a tree.
//
// One thread ticks and halts; it owns everything here but the inbox, which any thread may post to.
// A steady tick allocates nothing, locks nothing and compares no strings.
//
//   WallClock clock;
//   Executor executor(program, clock);
//   Sender<double> battery = executor.Writer<double>("battery_level");
//   while (executor.Tick() == Status::kRunning) clock.WaitUntil(executor.next_tick(),
//   executor.wake_up());
#ifndef COPPICE_BT_CORE_ENGINE_EXECUTOR_H_
#define COPPICE_BT_CORE_ENGINE_EXECUTOR_H_

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bt_core/data/inbox.h"
#include "bt_core/engine/events.h"
#include "bt_core/engine/program.h"

namespace coppice {

class Executor final : public LeafHost, public ChildHost {
 public:
  /// Builds the leaves. The clock must live as long as the executor.
  Executor(std::shared_ptr<const Program> program, Clock& clock);
  ~Executor();  // halts what runs
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  /// One tick: applies the inbox, ticks the root, reports to the sinks.
  Status Tick();

  /// Halts the whole tree; running leaves are told.
  void Halt();

  /// Runs the functions that were posted with Inbox::PostCall. Between ticks.
  void RunCalls();

  /// When the tree wants the next tick at the latest: now if a node asked for it, else the nearest
  /// timer.
  Time next_tick() const { return tick_again_ ? Time(0) : wake_at_; }

  const Program& program() const { return *program_; }
  std::shared_ptr<const Program> shared_program() const { return program_; }
  Clock& clock() { return clock_; }
  std::uint64_t ticks() const { return ticks_; }
  const std::vector<Status>& statuses() const { return statuses_; }
  const Blackboard& blackboard() const { return blackboard_; }

  const std::shared_ptr<Inbox>& inbox() { return inbox_; }
  WakeUp& wake_up() { return inbox_->wake_up(); }

  /// A sender for a key of the main tree, for any thread. A key that the tree does not use gives a
  /// sender that drops. Throws std::invalid_argument if the tree uses the key with another type.
  template <class T>
  Sender<T> Writer(const std::string& key) {
    const SlotIndex slot = program_->layout.Find(0, key);
    if (slot == kNoSlot) return {};
    CheckType(slot, TypeOf<T>());
    return Sender<T>(inbox_, slot, 0);
  }

  /// Sinks must live as long as the executor or be removed. Between ticks.
  void AddSink(TickSink* sink);
  void RemoveSink(TickSink* sink);

  void AddMessage(std::string text) override;
  void Drain(Duration limit) override;
  Status TickChild(NodeIndex node) override { return Tick(node); }
  void HaltChild(NodeIndex node) override { Halt(node); }
  Status StatusOfChild(NodeIndex node) const override { return statuses_[node]; }

  // The Tree of bt_core/nodes/control.h.
  Status Tick(NodeIndex node) {
    const NodeType type = nodes_[node].type;
    return type == NodeType::kLeaf ? TickLeaf(node) : TickInner(node, type);
  }
  void Halt(NodeIndex node) {
    if (statuses_[node] == Status::kIdle) return;
    if (statuses_[node] == Status::kRunning) return HaltRunning(node);
    SetStatus(node, Status::kIdle);
  }
  void ResetChildren(NodeIndex node);
  Status status(NodeIndex node) const { return statuses_[node]; }
  std::uint64_t& memory(NodeIndex node) { return memory_[node]; }
  NodeIndex EndOf(NodeIndex node) const { return nodes_[node].end; }
  template <class T>
  const T& Port(NodeIndex node, std::uint32_t k) const {
    const Slot& slot = blackboard_[Binding(node, k)];
    if (!slot.value.has_value()) throw UnsetInput(&slot);
    return slot.value.Get<T>();
  }
  Slot* SlotOf(NodeIndex node, std::uint32_t k) {
    const SlotIndex slot = Binding(node, k);
    return slot == kNoSlot ? nullptr : &blackboard_[slot];
  }
  template <class T>
  T& Own(NodeIndex node, std::uint32_t k) {
    Value& value = blackboard_[Binding(node, k)].value;
    if (!value.has_value()) value.Set(T());
    return value.Get<T>();
  }
  void RunScript(NodeIndex node, std::uint32_t k) {
    program_->scripts[Binding(node, k)].Run(blackboard_);
  }
  bool TestScript(NodeIndex node, std::uint32_t k) {
    return program_->scripts[Binding(node, k)].Test(blackboard_);
  }
  void TickAgain() { tick_again_ = true; }

 private:
  Status TickInner(NodeIndex node, NodeType type);
  Status DispatchOthers(NodeIndex node, NodeType type);  // dispatch_others.cc
  Status TickOthers(NodeIndex node, NodeType type);
  std::uint32_t Binding(NodeIndex node, std::uint32_t k) const {
    return program_->ports[nodes_[node].first_port + k].slot;
  }
  Status TickLeaf(NodeIndex node);
  Status RefuseIdle();
  Status FailByException(NodeIndex node);
  Status Store(NodeIndex node, Status result);  // of a node that has no memory
  Status StoreAndForget(NodeIndex node, Status result);
  void SetStatus(NodeIndex node, Status status) {
    if (listening_) RecordChange(node, status);
    statuses_[node] = status;
  }
  void RecordChange(NodeIndex node, Status status);
  void HaltRunning(NodeIndex node);
  void HaltLeaf(NodeIndex node);
  std::string Describe(const UnsetInput& error, NodeIndex node) const;
  void BuildLeaves();
  void ApplyInbox();
  void Report(Status result);
  void CheckType(SlotIndex slot, const Type& type) const;

  std::shared_ptr<const Program> program_;
  const NodeRecord* nodes_;
  Clock& clock_;
  std::shared_ptr<Inbox> inbox_;

  std::vector<Status> statuses_;
  std::vector<std::uint64_t> memory_;
  Blackboard blackboard_;
  std::vector<std::unique_ptr<UserNode>> leaves_;

  std::uint64_t ticks_ = 0;
  bool tick_again_ = false;
  NodeIndex current_leaf_ = 0;

  std::vector<TickSink*> sinks_;
  bool listening_ = false;  // someone wants events
  std::vector<StatusChange> changes_;
  std::vector<NodeMessage> messages_;
  std::vector<SlotIndex> writes_;
  std::vector<std::uint32_t> reported_writes_;  // per slot, when listening
  std::vector<Inbox::Message> delivery_;
  std::vector<Inbox::Call> calls_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EXECUTOR_H_
