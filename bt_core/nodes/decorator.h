// What the decorators do in one tick. The Tree is described in control.h; in addition:
//
//   Time now()              when this tick began
//   void WakeAt(time)       asks for a tick at that time at the latest
//   void TickAgain()        asks for the next tick at once
//
// A decorator makes its child idle when the child has completed. SKIPPED passes through every one
// of them.
#ifndef COPPICE_BT_CORE_NODES_DECORATOR_H_
#define COPPICE_BT_CORE_NODES_DECORATOR_H_

#include <chrono>
#include <cstdint>

#include "bt_core/base/clock.h"
#include "bt_core/nodes/control.h"

namespace coppice {

/// Ticks the child and passes its result on, with success and failure replaced as given.
template <class Tree>
Status TickMapped(Tree& tree, NodeIndex node, Status on_success, Status on_failure) {
  const NodeIndex child = node + 1;
  const Status result = tree.Tick(child);
  if (result == Status::kRunning) return result;
  tree.ResetChildren(node);
  if (result == Status::kSuccess) return on_success;
  return result == Status::kFailure ? on_failure : result;
}

namespace internal {

// Repeat and RetryUntilSuccessful: run the child again after `kAgain`, at most `limit` times
// (negative: no limit). Memory: how often it has completed. A child that completes in its first
// tick ends the tick, so a fast child cannot keep the rest of the tree waiting; one that ran over
// several ticks is started again in the same tick.
template <Status kAgain, class Tree>
Status TickLoop(Tree& tree, NodeIndex node, int limit) {
  const NodeIndex child = node + 1;
  std::uint64_t& count = tree.memory(node);
  const auto more = [&] { return limit < 0 || count < static_cast<std::uint64_t>(limit); };
  while (more()) {
    const bool starts_now = tree.status(child) != Status::kRunning;
    const Status result = tree.Tick(child);
    if (result == Status::kRunning) return result;
    tree.ResetChildren(node);
    if (result != kAgain) return result;
    ++count;
    if (starts_now && more()) {
      tree.TickAgain();
      return Status::kRunning;
    }
  }
  return kAgain;
}

}  // namespace internal

template <class Tree>
Status TickRepeat(Tree& tree, NodeIndex node) {
  return internal::TickLoop<Status::kSuccess>(tree, node, tree.template Port<int>(node, 0));
}

template <class Tree>
Status TickRetryUntilSuccessful(Tree& tree, NodeIndex node) {
  return internal::TickLoop<Status::kFailure>(tree, node, tree.template Port<int>(node, 0));
}

/// Memory: the time of expiry, plus 1 so that it is never 0. The child is halted at the first tick
/// at or after it, before it is ticked again.
template <class Tree>
Status TickTimeout(Tree& tree, NodeIndex node) {
  const NodeIndex child = node + 1;
  std::uint64_t& memory = tree.memory(node);
  const unsigned limit = tree.template Port<unsigned>(node, 0);
  if (limit > 0) {
    if (memory == 0) {
      const Time expiry = tree.now() + std::chrono::milliseconds(limit);
      memory = static_cast<std::uint64_t>(expiry.count()) + 1;
    }
    const Time expiry(static_cast<std::int64_t>(memory - 1));
    if (tree.now() >= expiry) {
      tree.Halt(child);
      return Status::kFailure;
    }
    tree.WakeAt(expiry);
  }
  return TickMapped(tree, node, Status::kSuccess, Status::kFailure);
}

/// Memory: the time from which the child is ticked, plus 1.
template <class Tree>
Status TickDelay(Tree& tree, NodeIndex node) {
  std::uint64_t& memory = tree.memory(node);
  if (memory == 0) {
    const std::chrono::milliseconds delay(tree.template Port<unsigned>(node, 0));
    memory = static_cast<std::uint64_t>((tree.now() + delay).count()) + 1;
  }
  const Time start(static_cast<std::int64_t>(memory - 1));
  if (tree.now() < start) {
    tree.WakeAt(start);
    return Status::kRunning;
  }
  return TickMapped(tree, node, Status::kSuccess, Status::kFailure);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_DECORATOR_H_
