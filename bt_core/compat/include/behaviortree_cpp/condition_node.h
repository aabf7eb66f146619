// Questions about the world.
#ifndef CONDITIONNODE_H
#define CONDITIONNODE_H

#include <functional>
#include <utility>

#include "behaviortree_cpp/leaf_node.h"

namespace BT {

/// Answered in tick(), at once.
class ConditionNode : public LeafNode {
 public:
  ConditionNode(const std::string& name, const NodeConfig& config) : LeafNode(name, config) {}
  void halt() final { resetStatus(); }
  NodeType type() const final { return NodeType::CONDITION; }
};

/// A function as a condition: BehaviorTreeFactory::registerSimpleCondition.
class SimpleConditionNode : public ConditionNode {
 public:
  using TickFunctor = std::function<NodeStatus(TreeNode&)>;
  SimpleConditionNode(const std::string& name, TickFunctor tick_functor, const NodeConfig& config)
      : ConditionNode(name, config), tick_functor_(std::move(tick_functor)) {}

 protected:
  NodeStatus tick() override { return tick_functor_(*this); }

  TickFunctor tick_functor_;
};

}  // namespace BT

#endif  // CONDITIONNODE_H
