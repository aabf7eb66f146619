// Finding one child among many. Children are numbered from 0 in document order; that number, not
// the NodeIndex, is what a node keeps beyond its activation.
#ifndef COPPICE_BT_CORE_NODES_CHILDREN_H_
#define COPPICE_BT_CORE_NODES_CHILDREN_H_

#include <cstdint>

#include "bt_core/base/status.h"
#include "bt_core/nodes/control.h"

namespace coppice::internal {

template <class Tree>
std::uint32_t CountChildren(const Tree& tree, NodeIndex node) {
  std::uint32_t count = 0;
  for (NodeIndex child = node + 1; child != tree.EndOf(node); child = tree.EndOf(child)) ++count;
  return count;
}

/// The k-th child; the end of the node if there are not so many.
template <class Tree>
NodeIndex ChildAt(const Tree& tree, NodeIndex node, std::uint64_t k) {
  NodeIndex child = node + 1;
  while (k > 0 && child != tree.EndOf(node)) {
    child = tree.EndOf(child);
    --k;
  }
  return child;
}

/// What a node returns that passes the result of its child on.
template <class Tree>
Status PassOn(Tree& tree, NodeIndex node, Status result) {
  if (result == Status::kSkipped) tree.LeaveChildren(node);
  if (IsCompleted(result)) tree.ResetChildren(node);
  return result;
}

/// Ends a node: its children become idle.
template <class Tree>
Status End(Tree& tree, NodeIndex node, Status result) {
  tree.ResetChildren(node);
  return result;
}

}  // namespace coppice::internal

#endif  // COPPICE_BT_CORE_NODES_CHILDREN_H_
