// Nodes without children.
#ifndef LEAFNODE_H
#define LEAFNODE_H

#include "behaviortree_cpp/tree_node.h"

namespace BT {

class LeafNode : public TreeNode {
 public:
  LeafNode(const std::string& name, const NodeConfig& config) : TreeNode(name, config) {}
};

}  // namespace BT

#endif  // LEAFNODE_H
