// Decorators that run their child again.
//
//   child      Repeat                       RetryUntilSuccessful         KeepRunningUntilFailure
//   SUCCESS    again; SUCCESS after the     SUCCESS                      RUNNING
//              last round
//   FAILURE    FAILURE                      again; FAILURE after the     FAILURE
//                                           last attempt
//   RUNNING    RUNNING                      RUNNING                      RUNNING
//   SKIPPED    SKIPPED                      SKIPPED                      RUNNING
//
// A round that took one tick ends the tick: the node yields, that is, it returns RUNNING and asks
// for the next tick at once, so a fast child cannot keep the rest of the tree waiting. After a
// round over several ticks the next one begins in the same tick. KeepRunningUntilFailure begins a
// round per tick and does not ask for it.
//
// What resets the number of rounds: SUCCESS and FAILURE of the node, and a halt. -1 rounds: for
// ever. With 0 rounds, or any other number that is reached before the first, the child is not
// ticked. Source: BehaviorTree.CPP 4.
#ifndef COPPICE_BT_CORE_NODES_RETRY_H_
#define COPPICE_BT_CORE_NODES_RETRY_H_

#include <cstdint>

#include "bt_core/nodes/children.h"

namespace coppice {
namespace internal {

// Runs the child again after `kAgain`. Memory: how often it has returned that.
template <Status kAgain, class Tree>
Status TickLoop(Tree& tree, NodeIndex node) {
  const NodeIndex child = node + 1;
  std::uint64_t& count = tree.memory(node);
  int limit = tree.template Port<int>(node, 0);
  const auto more = [&] { return limit == -1 || static_cast<std::int64_t>(count) < limit; };
  while (more()) {
    const bool starts_now = tree.status(child) != Status::kRunning;
    const Status result = tree.Tick(child);
    if (result == Status::kRunning) return result;
    tree.ResetChildren(node);
    if (result != kAgain) return result;
    ++count;
    if (kAgain == Status::kFailure) limit = tree.template Port<int>(node, 0);
    if (starts_now && more()) {
      tree.TickAgain();
      return Status::kRunning;
    }
  }
  return End(tree, node, kAgain);
}

}  // namespace internal

/// The number of rounds is read at the start of each tick.
template <class Tree>
Status TickRepeat(Tree& tree, NodeIndex node) {
  return internal::TickLoop<Status::kSuccess>(tree, node);
}

/// The number of attempts is read at the start of each tick and after each failure.
template <class Tree>
Status TickRetryUntilSuccessful(Tree& tree, NodeIndex node) {
  return internal::TickLoop<Status::kFailure>(tree, node);
}

template <class Tree>
Status TickKeepRunningUntilFailure(Tree& tree, NodeIndex node) {
  const Status result = internal::PassOn(tree, node, tree.Tick(node + 1));
  return result == Status::kFailure ? result : Status::kRunning;
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_RETRY_H_
