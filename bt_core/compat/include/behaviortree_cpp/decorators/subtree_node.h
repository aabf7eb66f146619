// A tree within a tree. The built-in node; what it does is in docs/semantics.md.
#pragma once

#include <string>

#include "behaviortree_cpp/internal/built_in.h"

namespace BT {

class SubTreeNode : public internal::BuiltIn<DecoratorNode> {
 public:
  using BuiltInClass = SubTreeNode;
  static constexpr const char* kBuiltInId = "SubTree";
  explicit SubTreeNode(const std::string& name, const NodeConfig& config = {})
      : BuiltIn(name, config) {}

  void setSubtreeID(const std::string& id) { subtree_id_ = id; }
  const std::string& subtreeID() const { return subtree_id_; }
  NodeType type() const final { return NodeType::SUBTREE; }

 private:
  std::string subtree_id_;
};

}  // namespace BT
