// Runs a Program: the mutable half of a tree.
//
// One thread ticks and halts; it owns everything here but the inbox, which any thread may post to.
// A steady tick allocates nothing, locks nothing and compares no strings.
//
//   WallClock clock;
//   Executor executor(program, clock);
//   Sender<double> battery = executor.Writer<double>("battery_level");
//   while (executor.Tick() == Status::kRunning) {
//     clock.WaitUntil(executor.next_tick(), executor.wake_up());
//   }
//
// Statuses lie in an array in the order of the nodes. When a node ends, its children are idle by
// definition; this is not written down, so the array may hold what they returned last. statuses()
// says what holds.
#ifndef COPPICE_BT_CORE_ENGINE_EXECUTOR_H_
#define COPPICE_BT_CORE_ENGINE_EXECUTOR_H_

#include <cstdint>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bt_core/data/inbox.h"
#include "bt_core/engine/events.h"
#include "bt_core/engine/events/tick_reporter.h"
#include "bt_core/engine/hooked_nodes.h"
#include "bt_core/engine/program.h"

namespace coppice {

/// What becomes of an exception that a node of the user or a script throws. In all cases the
/// sinks get the text as a message of that node, and the tree is left consistent.
enum class ExceptionPolicy : std::uint8_t {
  kFailNode,  ///< the node fails and the tree goes on
  kHaltTree,  ///< the whole tree is halted; the tick returns FAILURE
  kRethrow,   ///< the whole tree is halted; the tick throws TickError
};

struct ExecutorOptions {
  ExceptionPolicy on_exception = ExceptionPolicy::kFailNode;
};

/// "PATH: TEXT" of a node that threw, under ExceptionPolicy::kRethrow. The original exception is
/// nested in it (std::rethrow_if_nested).
struct TickError : std::runtime_error {
  TickError(NodeIndex at, const std::string& text) : std::runtime_error(text), node(at) {}
  NodeIndex node;
};

/// The state of a tree between two ticks: what the built-in nodes remember and what is on the
/// blackboard. Nodes of the user keep what they remember for themselves.
struct TreeState {
  std::vector<Status> statuses;
  std::vector<std::uint64_t> memory;
  Blackboard blackboard;
};

class Executor final : public LeafHost, public ChildHost {
 public:
  /// Builds the nodes of the user. The clock must live as long as the executor.
  Executor(std::shared_ptr<const Program> program, Clock& clock, ExecutorOptions options = {});
  ~Executor();  // halts what runs
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  /// One tick: applies the inbox, ticks the root, reports to the sinks.
  Status Tick();

  /// Halts the whole tree; running leaves are told.
  void Halt();

  /// True while a halted leaf has not stopped yet (Action::OnDraining). Each tick asks it.
  bool is_draining() const { return !drains_.empty(); }

  /// Applies the inbox and asks the halted leaves whether they have stopped, without a tick.
  /// Afterwards next_tick() is when to ask again at the latest.
  void ServeDrains();

  /// The state of the tree as a value. Between ticks.
  TreeState Save() const;

  /// Makes the tree as it was when Save was called on it or on another executor of the same
  /// program. A node of the user that has begun something now and had not then is halted; one that
  /// had and has not now is started by the next tick, since only the node itself knows how far it
  /// was. (It has begun when it is RUNNING, or was and then SKIPPED.) A tree that runs then asks
  /// for the next tick at once. The sinks are told of a jump. Throws std::invalid_argument if the
  /// state is that of another program. Between ticks.
  void Restore(const TreeState& state);

  /// Goes on with another program. A node lives on, with its status and memory, if it is written
  /// the same (type, attributes, number of children) at the same place below nodes that live on;
  /// what does not is halted and begins anew. Keys of the same scope, name and type keep their
  /// values, and Senders stay valid. A tree that runs asks for the next tick at once. The sinks are
  /// told of a jump. Hooks are taken away: nodes have new numbers. Between ticks.
  void Reload(std::shared_ptr<const Program> next);

  /// Runs the functions that were posted with Inbox::PostCall. Between ticks.
  void RunCalls();

  /// When the tree wants the next tick at the latest: now if a node asked for it, else the nearest
  /// timer.
  Time next_tick() const { return tick_again_ ? Time{} : wake_at_; }

  const Program& program() const { return *program_; }
  std::shared_ptr<const Program> shared_program() const { return program_; }
  Clock& clock() { return clock_; }
  std::uint64_t ticks() const { return ticks_; }
  /// Status of every node, as it is between ticks.
  std::vector<Status> statuses() const;
  /// Status of one node, the same way.
  Status StatusOf(NodeIndex node) const;
  const Blackboard& blackboard() const { return blackboard_; }
  /// For front ends that give programs their own way to the keys: whoever writes a slot keeps its
  /// type (SlotDefinition) and counts the write. Ticking thread.
  Blackboard& blackboard() { return blackboard_; }

  /// The node of the user at that place, made by its Registry::Entry.
  UserNode& user_node(NodeIndex node) { return *UserOf(node).node; }

  const std::shared_ptr<Inbox>& inbox() { return inbox_; }
  WakeUp& wake_up() { return inbox_->wake_up(); }

  /// A sender for a key of the main tree, for any thread. A key that the tree does not use gives a
  /// sender that drops. Throws std::invalid_argument if the tree uses the key with another type.
  template <class T>
  Sender<T> Writer(const std::string& key) {
    const SlotIndex slot = program_->layout.Find(kMainScope, key);
    if (slot == kNoSlot) return {};
    CheckType(slot, TypeOf<T>());
    return Sender<T>(inbox_, slot, 0);
  }

  /// Sinks must live as long as the executor or be removed. Between ticks.
  void AddSink(TickSink* sink) { reporter_.Add(sink, *program_); }
  void RemoveSink(TickSink* sink) { reporter_.Remove(sink); }

  /// Asks `hooks` before every tick, and before and after each tick of these nodes; null takes the
  /// hooks away. They must live until then. Between ticks; also from within a hook, with at least
  /// one node.
  void SetHooks(NodeHooks* hooks, const std::vector<NodeIndex>& nodes = {});

  /// From within a hook: the sinks get what has happened in this tick so far.
  void ReportSoFar() { reporter_.SoFar(ticks_, now_); }

  void AddMessage(std::string text) override {
    reporter_.Text(current_, EventText::kMessage, text);
  }
  NodeIndex current_node() const override { return current_; }
  bool ResumeSkipped() override;
  void KeepSkipped() override;
  void Drain(Duration limit) override;
  Status TickChild(NodeIndex node) override;
  void HaltChild(NodeIndex node) override;
  Status StatusOfChild(NodeIndex node) const override { return statuses_[node]; }

  // The Tree of bt_core/nodes/control.h.
  Status Tick(NodeIndex node);
  void Halt(NodeIndex node) {
    if (statuses_[node] == Status::kRunning) return HaltRunning(node);
    if (kept_ != 0) LetGo(node);
    if (statuses_[node] != Status::kIdle) MakeIdle(node);
  }
  void ResetChildren(NodeIndex node);
  void LeaveChildren(NodeIndex node);
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
  bool HasScript(NodeIndex node, std::uint32_t k) const { return ScriptOf(node, k) != kNoScript; }
  const Type* TypeOfPort(NodeIndex node, std::uint32_t k) const {
    return program_->layout.slots[Binding(node, k)].type;
  }
  template <class T>
  T& Own(NodeIndex node, std::uint32_t k) {
    Value& value = blackboard_[Binding(node, k)].value;
    if (!value.has_value()) value.Set(T());
    return value.Get<T>();
  }
  void RunScript(NodeIndex node, std::uint32_t k) {
    program_->scripts[ScriptOf(node, k)].Run(blackboard_);
  }
  bool TestScript(NodeIndex node, std::uint32_t k) {
    return program_->scripts[ScriptOf(node, k)].Test(blackboard_);
  }
  const ScriptConstants& constants() const { return program_->registry->script_constants(); }
  void TickAgain() { tick_again_ = true; }

 private:
  // How a kind of node is ticked: one function for each, in a table (tick.cc).
  struct TickTable;
  struct User {
    std::unique_ptr<UserNode> node;
    Registry::TickFunction tick;
  };
  struct Draining {
    NodeIndex node;
    Time until;
    Registry::TickFunction tick;       // of the leaf; meanwhile it waits
    std::unique_ptr<UserNode> orphan;  // the leaf, if its tree was swapped for one without it
  };
  struct Abort {};  // ends a tick from within

  Status DispatchOthers(NodeIndex node, NodeType type);  // dispatch_others.cc
  Status TickGuarded(NodeIndex node, bool hooked);
  Status AskGuards(const GuardRecord& guards, NodeIndex node, bool running);
  void RunHook(const GuardRecord& guards, Guard hook);
  void RunHaltedHook(NodeIndex node);
  Status TickAsItself(NodeIndex node);
  Status TickHooked(NodeIndex node);
  Status Inject(NodeIndex node, Status status);
  void KeepPretending(const std::vector<NodeIndex>& nodes);
  bool IsGuarded(NodeIndex node) const {
    return program_->nodes[node].dispatch == NodeType::kGuarded;
  }
  const GuardRecord& GuardsOf(NodeIndex node) const;
  SlotIndex Binding(NodeIndex node, std::uint32_t k) const {
    return program_->ports[nodes_[node].first_port + k].slot;
  }
  ScriptIndex ScriptOf(NodeIndex node, std::uint32_t k) const {
    return program_->ports[nodes_[node].first_port + k].script;
  }
  Status FailByException(NodeIndex node);
  void AddExceptionMessage(NodeIndex node);
  Status EndAborted();
  [[noreturn]] void Rethrow();
  Status Store(NodeIndex node, Status result) {
    if (reporter_.is_listening()) return reporter_.Store(statuses_.data(), node, result);
    return statuses_[node] = result;
  }
  void MakeIdle(NodeIndex node) {
    reporter_.Reset(node);
    statuses_[node] = Status::kIdle;
  }

  // What skipped nodes keep (halt.cc).
  bool Keeps(NodeIndex node) const {
    return statuses_[node] != Status::kRunning && memory_[node] != 0;
  }
  bool HasBegun(NodeIndex user);
  void CountKept();
  void ChangeKept(int by) {
    kept_ += static_cast<std::uint32_t>(by);
    resets_children_ = kept_ != 0;
  }
  [[gnu::cold]] void Resume(NodeIndex node);
  [[gnu::cold]] void LetGo(NodeIndex node);
  void Forget(NodeIndex node);
  void KeepSomeMemory(NodeIndex node);  // dispatch_others.cc

  void HaltAll();
  void HaltRunning(NodeIndex node);
  void HaltDescendants(NodeIndex node);
  void CatchHaltOf(NodeIndex node);
  void HaltUser(NodeIndex node);
  User& UserOf(NodeIndex node) { return users_[nodes_[node].first_port]; }
  std::string Describe(const UnsetInput& error, NodeIndex node) const;
  bool HasStopped(Draining& drain);
  void BuildUser(const LeafRecord& record);
  void BindPorts(const LeafRecord& record);
  void RestoreUser(NodeIndex node, const TreeState& state);
  void RestoreBlackboard(const Blackboard& saved);
  void HaltWhatEnds(const std::vector<NodeIndex>& lives_on);
  void MoveBlackboard(const std::vector<SlotIndex>& slots);
  void MoveNodes(const Program& old, const std::vector<NodeIndex>& lives_on);
  void MoveUsers(const Program& old, const std::vector<NodeIndex>& lives_on);
  void GiveChildren(UserNode& node, NodeIndex index);
  void ApplyInbox();
  void CheckType(SlotIndex slot, const Type& type) const;

  std::shared_ptr<const Program> program_;
  const NodeRecord* nodes_;
  Clock& clock_;
  std::shared_ptr<Inbox> inbox_;

  std::vector<Status> statuses_;
  std::vector<std::uint64_t> memory_;
  Blackboard blackboard_;
  std::vector<User> users_;
  std::vector<PortBase*> user_ports_;  // of all user nodes, in their order
  std::vector<Draining> drains_;
  const ExecutorOptions options_;

  std::uint64_t ticks_ = 0;
  bool tick_again_ = false;
  NodeIndex current_{0};  // the node of the user that is called
  NodeIndex thrower_{0};
  std::exception_ptr thrown_;

  TickReporter reporter_{blackboard_};
  bool resets_children_ = false;  // when a node ends, its children are halted one by one

  HookedNodes hooked_;

  std::vector<Inbox::Message> delivery_;
  std::vector<Inbox::Call> calls_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EXECUTOR_H_
