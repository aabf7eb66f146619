// Nodes that wait. They read the tree's clock, at the start of the tick, and ask the run loop for a
// tick at exactly the time they wait for; there are no threads.
//
//   node     before the time is over        from then on            child's result
//   Delay    RUNNING, child not ticked      ticks the child         passed on
//   Timeout  ticks the child                halts it, FAILURE       passed on
//   Sleep    RUNNING                        SUCCESS                 -
//
// Time runs from the first tick of the activation and starts anew after a halt. SKIPPED is passed
// on as well. Source: BehaviorTree.CPP 4.
#ifndef COPPICE_BT_CORE_NODES_TIMING_H_
#define COPPICE_BT_CORE_NODES_TIMING_H_

#include <chrono>
#include <cstdint>

#include "bt_core/base/clock.h"
#include "bt_core/nodes/children.h"

namespace coppice {
namespace internal {

// The time `msec` after the first tick of the activation. Memory: that time plus 1, so it is not 0.
template <class Tree>
Time EndOfWaiting(Tree& tree, NodeIndex node, unsigned msec) {
  std::uint64_t& memory = tree.memory(node);
  if (memory == 0) {
    const Time end = tree.now() + std::chrono::milliseconds(msec);
    memory = static_cast<std::uint64_t>(ToNanoseconds(end)) + 1;
  }
  return TimeFromNanoseconds(static_cast<std::int64_t>(memory - 1));
}

}  // namespace internal

/// A limit of 0 means none.
template <class Tree>
Status TickTimeout(Tree& tree, NodeIndex node) {
  const unsigned limit = tree.template Port<unsigned>(node, 0);
  if (limit > 0) {
    const Time expiry = internal::EndOfWaiting(tree, node, limit);
    if (tree.now() >= expiry) return internal::End(tree, node, Status::kFailure);
    tree.WakeAt(expiry);
  }
  return internal::PassOn(tree, node, tree.Tick(node + 1));
}

template <class Tree>
Status TickDelay(Tree& tree, NodeIndex node) {
  const unsigned delay = tree.template Port<unsigned>(node, 0);
  const Time start = internal::EndOfWaiting(tree, node, delay);
  if (tree.now() >= start) return internal::PassOn(tree, node, tree.Tick(node + 1));
  tree.WakeAt(start);
  return Status::kRunning;
}

template <class Tree>
Status TickSleep(Tree& tree, NodeIndex node) {
  const Time end = internal::EndOfWaiting(tree, node, tree.template Port<unsigned>(node, 0));
  if (tree.now() >= end) return Status::kSuccess;
  tree.WakeAt(end);
  return Status::kRunning;
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_TIMING_H_
