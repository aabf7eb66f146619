// Control nodes: what users derive from, and the base of the built-in ones.
#pragma once

#include <cstddef>
#include <vector>

#include "behaviortree_cpp/tree_node.h"

namespace BT {

/// A class of the user's ticks children by child->executeTick(). When it returns anything but
/// RUNNING, the engine resets the children that it has left; when it is halted, halt() is called,
/// which halts them.
class ControlNode : public TreeNode {
 protected:
  std::vector<TreeNode*> children_nodes_;

 public:
  ControlNode(const std::string& name, const NodeConfig& config) : TreeNode(name, config) {}

  void addChild(TreeNode* child) { children_nodes_.push_back(child); }
  std::size_t childrenCount() const { return children_nodes_.size(); }
  const std::vector<TreeNode*>& children() const { return children_nodes_; }
  const TreeNode* child(std::size_t index) const { return children_nodes_.at(index); }

  void halt() override;
  void haltChildren();
  [[deprecated("use haltChildren() or haltChild(i)")]] void haltChildren(std::size_t first);
  /// Halts the child if it is RUNNING, and makes it IDLE.
  void haltChild(std::size_t index);
  void resetChildren();
  NodeType type() const final { return NodeType::CONTROL; }
};

}  // namespace BT
