// LoopInt, LoopBool, LoopDouble, LoopString: run the child once for each element of a list.
//
//   child      SUCCESS          FAILURE    RUNNING    SKIPPED          no element is left
//   result     RUNNING; yields  FAILURE    RUNNING    RUNNING; yields  the port `if_empty`
//
// Before each round the next element is written to the port `value`. To yield is to return RUNNING
// and ask for the next tick at once. The list, a literal such as 1;2;3 or a key, is only read, in
// the round in which the element is wanted, so it may grow meanwhile. Every activation begins with
// the first element. `if_empty="SKIPPED"` ends no activation: the elements stay taken until the
// parent resets the loop. Source: BehaviorTree.CPP 4, which copies the list of a key once and for
// all.
#ifndef COPPICE_BT_CORE_NODES_LOOP_H_
#define COPPICE_BT_CORE_NODES_LOOP_H_

#include <vector>

#include "bt_core/data/blackboard.h"
#include "bt_core/data/standard_types.h"
#include "bt_core/nodes/children.h"
#include "bt_core/nodes/result_port.h"

namespace coppice {
namespace internal {

// Memory: the number of elements that were taken.
template <class T, class Tree>
Status TickLoopOver(Tree& tree, NodeIndex node) {
  if (tree.status(node + 1) != Status::kRunning) {
    const auto& list = tree.template Port<std::vector<T>>(node, 0);
    std::uint64_t& taken = tree.memory(node);
    if (taken >= list.size()) return ResultPort(tree, node, 1);
    if (Slot* const value = tree.SlotOf(node, 2)) {
      value->value.Set<T>(list[taken]);
      value->CountWrite(tree.now());
    }
    ++taken;
  }
  const Status result = tree.Tick(node + 1);
  if (result == Status::kRunning) return result;
  tree.ResetChildren(node);
  if (result == Status::kFailure) return result;
  tree.TickAgain();
  return Status::kRunning;
}

}  // namespace internal

template <class Tree>
Status TickLoopInt(Tree& tree, NodeIndex node) {
  return internal::TickLoopOver<int>(tree, node);
}

template <class Tree>
Status TickLoopBool(Tree& tree, NodeIndex node) {
  return internal::TickLoopOver<bool>(tree, node);
}

template <class Tree>
Status TickLoopDouble(Tree& tree, NodeIndex node) {
  return internal::TickLoopOver<double>(tree, node);
}

template <class Tree>
Status TickLoopString(Tree& tree, NodeIndex node) {
  return internal::TickLoopOver<std::string>(tree, node);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_LOOP_H_
