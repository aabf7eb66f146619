// TryCatch: a sequence with a child that cleans up after a failure.
//
//   in         SUCCESS                  FAILURE                    RUNNING   SKIPPED
//   the try    next; SUCCESS after      reset, then ticks the      RUNNING   next; SKIPPED if all
//   children   the last                 last child                           were skipped
//   the last   FAILURE                  FAILURE                    RUNNING   FAILURE
//
// With catch_on_halt, a halt while a try child runs ticks the last child once, and halts it if it
// is RUNNING then. Source: BehaviorTree.CPP 4.9.
#ifndef COPPICE_BT_CORE_NODES_TRY_CATCH_H_
#define COPPICE_BT_CORE_NODES_TRY_CATCH_H_

#include <cstdint>

#include "bt_core/nodes/children.h"

namespace coppice {
namespace internal {

constexpr std::uint64_t kTried = std::uint64_t{1} << 63;  // a try child was not skipped

template <class Tree>
NodeIndex LastChild(const Tree& tree, NodeIndex node) {
  NodeIndex child = node + 1;
  while (tree.EndOf(child) != tree.EndOf(node)) child = tree.EndOf(child);
  return child;
}

template <class Tree>
Status TickCatch(Tree& tree, NodeIndex node, NodeIndex last) {
  tree.memory(node) = last;
  const Status result = tree.Tick(last);
  return result == Status::kRunning ? result : End(tree, node, Status::kFailure);
}

}  // namespace internal

/// Memory: the child to resume at, and kTried.
template <class Tree>
Status TickTryCatch(Tree& tree, NodeIndex node) {
  const NodeIndex last = internal::LastChild(tree, node);
  bool tried = (tree.memory(node) & internal::kTried) != 0;
  const auto resume_at = static_cast<NodeIndex>(tree.memory(node));
  for (NodeIndex child = resume_at ? resume_at : node + 1; child != last;
       child = tree.EndOf(child)) {
    const Status result = tree.Tick(child);
    if (result == Status::kRunning) {
      tree.memory(node) = child | (tried ? internal::kTried : 0);
      return result;
    }
    if (result == Status::kFailure) {
      tree.ResetChildren(node);
      return internal::TickCatch(tree, node, last);
    }
    tried |= result == Status::kSuccess;
  }
  if (resume_at == last) return internal::TickCatch(tree, node, last);
  return internal::End(tree, node, tried ? Status::kSuccess : Status::kSkipped);
}

/// Before a TryCatch that is RUNNING is halted: what catch_on_halt asks for.
template <class Tree>
void CatchHalt(Tree& tree, NodeIndex node) {
  const NodeIndex last = internal::LastChild(tree, node);
  if (tree.memory(node) == last || !tree.template Port<bool>(node, 0)) return;
  for (NodeIndex child = node + 1; child != last; child = tree.EndOf(child)) tree.Halt(child);
  tree.Tick(last);
  tree.Halt(last);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_TRY_CATCH_H_
