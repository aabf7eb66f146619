// Decorators: nodes with one child.
#ifndef DECORATORNODE_H
#define DECORATORNODE_H

#include <functional>
#include <utility>

#include "behaviortree_cpp/tree_node.h"

namespace BT {

/// As ControlNode.
class DecoratorNode : public TreeNode {
 protected:
  TreeNode* child_node_ = nullptr;

 public:
  DecoratorNode(const std::string& name, const NodeConfig& config) : TreeNode(name, config) {}

  void setChild(TreeNode* child);
  const TreeNode* child() const { return child_node_; }
  TreeNode* child() { return child_node_; }

  void halt() override;
  void haltChild() { resetChild(); }
  void resetChild();
  NodeType type() const override { return NodeType::DECORATOR; }
  /// A child that has completed is made IDLE.
  NodeStatus executeTick() override;
};

/// A function of the child's status as a decorator: BehaviorTreeFactory::registerSimpleDecorator.
class SimpleDecoratorNode : public DecoratorNode {
 public:
  using TickFunctor = std::function<NodeStatus(NodeStatus, TreeNode&)>;
  SimpleDecoratorNode(const std::string& name, TickFunctor tick_functor, const NodeConfig& config)
      : DecoratorNode(name, config), tick_functor_(std::move(tick_functor)) {}

 protected:
  NodeStatus tick() override { return tick_functor_(child_node_->executeTick(), *this); }

  TickFunctor tick_functor_;
};

}  // namespace BT

#endif  // DECORATORNODE_H
