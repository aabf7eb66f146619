// Actions: classes to derive from.
//
//   class Say : public BT::SyncActionNode {
//    public:
//     Say(const std::string& name, const BT::NodeConfig& config) : SyncActionNode(name, config) {}
//     static BT::PortsList providedPorts() { return {BT::InputPort<std::string>("text")}; }
//     BT::NodeStatus tick() override { ... getInput<std::string>("text") ... }
//   };
#ifndef BEHAVIORTREECORE_ACTIONNODE_H
#define BEHAVIORTREECORE_ACTIONNODE_H

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "behaviortree_cpp/leaf_node.h"

namespace BT {

/// tick() and halt() are the class's own.
class ActionNodeBase : public LeafNode {
 public:
  ActionNodeBase(const std::string& name, const NodeConfig& config) : LeafNode(name, config) {}
  NodeType type() const final { return NodeType::ACTION; }
};

/// Done within one tick; RUNNING throws LogicError.
class SyncActionNode : public ActionNodeBase {
 public:
  SyncActionNode(const std::string& name, const NodeConfig& config)
      : ActionNodeBase(name, config) {}
  NodeStatus executeTick() override;
  void halt() final { resetStatus(); }
};

/// A function as an action: BehaviorTreeFactory::registerSimpleAction.
class SimpleActionNode : public SyncActionNode {
 public:
  using TickFunctor = std::function<NodeStatus(TreeNode&)>;
  SimpleActionNode(const std::string& name, TickFunctor tick_functor, const NodeConfig& config)
      : SyncActionNode(name, config), tick_functor_(std::move(tick_functor)) {}

 protected:
  // Those who watch see it RUNNING first, though it is done at once.
  NodeStatus tick() final {
    if (status() == NodeStatus::IDLE) setStatus(NodeStatus::RUNNING);
    return tick_functor_(*this);
  }

  TickFunctor tick_functor_;
};

/// tick() runs on a thread of its own; the node is RUNNING meanwhile. A long tick() asks
/// isHaltRequested() now and then: halt() waits for it.
class ThreadedAction : public ActionNodeBase {
 public:
  ThreadedAction(const std::string& name, const NodeConfig& config)
      : ActionNodeBase(name, config) {}
  bool isHaltRequested() const { return halt_requested_.load(); }
  NodeStatus executeTick() final;
  void halt() override;

 private:
  std::atomic<bool> halt_requested_{false};
  std::future<NodeStatus> result_;
};
#ifdef USE_BTCPP3_OLD_NAMES
class AsyncActionNode : public ThreadedAction {
 public:
  using ThreadedAction::ThreadedAction;
};
#endif

/// Takes more than one tick, and no thread.
class StatefulActionNode : public ActionNodeBase {
 public:
  StatefulActionNode(const std::string& name, const NodeConfig& config)
      : ActionNodeBase(name, config) {}
  /// First tick of an activation.
  virtual NodeStatus onStart() = 0;
  /// Every further tick while it is RUNNING.
  virtual NodeStatus onRunning() = 0;
  /// It was RUNNING and is no longer wanted.
  virtual void onHalted() = 0;
  bool isHaltRequested() const { return halt_requested_.load(); }

 protected:
  NodeStatus tick() final;
  void halt() final;

 private:
  std::atomic<bool> halt_requested_{false};
};

/// tick() is a coroutine: setStatusRunningAndYield() ends this tick, and the next one goes on
/// behind it. A halt ends the coroutine; the destructors of what lives in tick() run.
class CoroActionNode : public ActionNodeBase {
 public:
  CoroActionNode(const std::string& name, const NodeConfig& config);
  ~CoroActionNode() override;
  void setStatusRunningAndYield();
  NodeStatus executeTick() final;
  /// Who overrides it calls this, too.
  void halt() override;

 private:
  class Coroutine;
  std::unique_ptr<Coroutine> coroutine_;
};

}  // namespace BT

#endif  // BEHAVIORTREECORE_ACTIONNODE_H
