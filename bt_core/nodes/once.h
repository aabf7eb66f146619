// Decorators that run their child once.
//
//   node           until the child has completed    then
//   RunOnce        passes its result on             SKIPPED; with then_skip="false" its result
//   SingleTrigger  passes its result on             FAILURE, for as long as it is ticked in every
//                                                   tick; after a tick without it, armed again
//
// RUNNING and SKIPPED are passed on; a child that was skipped or halted has not completed. Nothing
// makes RunOnce run again in the same tree. Sources: BehaviorTree.CPP 4; Nav2 for SingleTrigger,
// which is armed again whenever its parent resets it: under a reactive node in every tick.
#ifndef COPPICE_BT_CORE_NODES_ONCE_H_
#define COPPICE_BT_CORE_NODES_ONCE_H_

#include <cstdint>

#include "bt_core/nodes/children.h"

namespace coppice {

/// Own slot 0: the result of the child, 0 before.
template <class Tree>
Status TickRunOnce(Tree& tree, NodeIndex node) {
  std::uint64_t& done = tree.template Own<std::uint64_t>(node, 1);
  if (done != 0) {
    return tree.template Port<bool>(node, 0) ? Status::kSkipped : static_cast<Status>(done);
  }
  const Status result = tree.Tick(node + 1);
  if (result == Status::kRunning) return result;
  if (IsCompleted(result)) done = static_cast<std::uint64_t>(result);
  return internal::PassOn(tree, node, result);
}

/// Own slot 0: number of the tick in which it was done, then of the last one in which it failed.
template <class Tree>
Status TickSingleTrigger(Tree& tree, NodeIndex node) {
  std::uint64_t& done_at = tree.template Own<std::uint64_t>(node, 0);
  if (done_at != 0 && done_at + 1 >= tree.ticks()) {
    done_at = tree.ticks();
    return Status::kFailure;
  }
  const Status result = tree.Tick(node + 1);
  if (result == Status::kRunning) return result;
  done_at = IsCompleted(result) ? tree.ticks() : 0;
  return internal::PassOn(tree, node, result);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_ONCE_H_
