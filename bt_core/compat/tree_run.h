// One tree of the BehaviorTree.CPP interface on one executor: what its nodes and blackboards share.
#ifndef COPPICE_BT_CORE_COMPAT_TREE_RUN_H_
#define COPPICE_BT_CORE_COMPAT_TREE_RUN_H_

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "behaviortree_cpp/tree_node.h"
#include "bt_core/engine/executor.h"

namespace BT::internal {

struct NodeCallbacks {
  TreeNode::PreTickCallback pre;
  TreeNode::PostTickCallback post;
  TreeNode::TickMonitorCallback monitor;
  TreeNode::StatusChangeSignal changes;
  NodeStatus shown = NodeStatus::IDLE;  // to those who watch the changes
  std::chrono::steady_clock::time_point start;
};

/// Thread: the ticking one, unless it says otherwise.
class TreeRun final : public coppice::NodeHooks {
 public:
  explicit TreeRun(std::shared_ptr<const coppice::Program> program);
  ~TreeRun() override;
  TreeRun(const TreeRun&) = delete;
  TreeRun& operator=(const TreeRun&) = delete;

  /// The value of the key lives in that slot from now on; if another tree has it already, the two
  /// are made the same before and after each tick of this one.
  void Attach(const std::shared_ptr<Cell>& cell, coppice::SlotIndex slot);
  /// The next node in preorder.
  void Add(TreeNode::Ptr node, std::vector<PortLink> links);

  /// Throw LogicError if a node of the tree calls them, or who watches one.
  NodeStatus Tick();
  void Halt();
  NodeStatus TickChild(const TreeNode& node);
  void HaltChild(const TreeNode& node);
  NodeStatus StatusOf(const TreeNode& node) const;

  /// Somebody wants to be called for nodes, from the next tick on.
  void CallsChanged() { calls_changed_ = true; }
  /// A node of the user's has set its own status.
  void OwnStatusSet(const TreeNode& node, NodeStatus status) { Show(node.index_, status); }

  /// Time until the tree wants a tick; zero: at once.
  coppice::Duration UntilNextTick();
  std::shared_ptr<WakeUpSignal> wake_up() const { return wake_up_; }  // any thread

  /// After each tick and halt, while changes are watched.
  Signal<>& tick_ended() { return tick_ended_; }

  coppice::Executor& executor() { return *executor_; }
  const std::vector<TreeNode::Ptr>& nodes() const { return nodes_; }
  Gate& gate() { return gate_; }
  bool is_child_of_user(const TreeNode& node) const;

  // Of the engine.
  std::optional<coppice::Status> Before(coppice::NodeIndex node) override;
  std::optional<coppice::Status> After(coppice::NodeIndex node, coppice::Status result) override;

  // A tick of a node by the engine. `before`: IDLE in the first one of an activation, RUNNING in
  // others. Whatever happens, Leave is called after Enter.
  static void Enter(TreeNode& node, NodeStatus before) {
    node.own_status_.store(before, std::memory_order_relaxed);
  }
  static NodeStatus TickEntered(TreeNode& node) {
    return node.has_scripts_ ? node.TickWithScripts() : node.executeTick();
  }
  static void Leave(TreeNode& node) {
    node.own_status_.store(TreeNode::kOutside, std::memory_order_relaxed);
  }
  void HaltNode(TreeNode& node);

 private:
  struct Shared {
    std::shared_ptr<Cell> cell;
    coppice::SlotIndex slot;
    std::uint32_t writes_there = 0;
    std::uint32_t writes_here = 0;
  };

  void RefuseFromWithin(const char* what) const;
  [[noreturn]] void RethrowOf(coppice::NodeIndex node);
  void ChooseCalled();
  void TakeShared();
  void GiveShared();
  void Show(std::uint32_t node, NodeStatus status);
  void ShowIdle(std::uint32_t node);
  void ShowChildren(std::uint32_t node, bool are_idle);

  Gate gate_;
  std::atomic<pthread_t> halting_{};  // a node, on that thread
  coppice::WallClock clock_;
  std::unique_ptr<coppice::Executor> executor_;
  std::shared_ptr<WakeUpSignal> wake_up_;
  std::vector<TreeNode::Ptr> nodes_;
  std::vector<std::shared_ptr<Cell>> own_;
  std::vector<Shared> shared_;
  Signal<> tick_ended_;
  bool calls_changed_ = false;
  bool is_watched_ = false;  // somebody wants the changes of a node
};

}  // namespace BT::internal

#endif  // COPPICE_BT_CORE_COMPAT_TREE_RUN_H_
