// Nodes that tick several children in the same tick, one after the other on the ticking thread.
//
//   node         after each child                             when no child is RUNNING any more
//   Parallel     S successes: SUCCESS. F failures, or too     skipped children count as absent: if
//                few children left for S: FAILURE             none failed SUCCESS, else FAILURE
//   ParallelAll  goes on                                      `max_failures` failed: FAILURE, else
//                                                             SUCCESS
//   WorstOf      goes on                                      the worst of FAILURE, RUNNING,
//                                                             SUCCESS in this tick
//
// S = success_count, F = failure_count; a negative number -k stands for all but k - 1 children. If
// S is negative, a child that is skipped in this tick counts as a success. Parallel and ParallelAll
// do not tick a child again that has completed in this activation; a skipped child is ticked again.
// All three are SKIPPED if all children were skipped in one tick and nothing else was decided.
// Source: BehaviorTree.CPP 4 for Parallel and ParallelAll.
#ifndef COPPICE_BT_CORE_NODES_PARALLEL_H_
#define COPPICE_BT_CORE_NODES_PARALLEL_H_

#include <algorithm>
#include <stdexcept>
#include <string>

#include "bt_core/nodes/children.h"

namespace coppice {
namespace internal {

// How many of `children` a port of a parallel node asks for.
inline int Threshold(int port, int children) {
  if (port > children) {
    throw std::invalid_argument("asks for " + std::to_string(port) + " of " +
                                std::to_string(children) + " children");
  }
  return port < 0 ? std::max(children + port + 1, 0) : port;
}

// Counts results of the children of a parallel node.
struct Tally {
  int success = 0;
  int failure = 0;
  int running = 0;
  int skipped = 0;

  void Add(Status result) {
    success += result == Status::kSuccess;
    failure += result == Status::kFailure;
    running += result == Status::kRunning;
    skipped += result == Status::kSkipped;
  }
};

// The children that have completed in this activation. Memory: 1 from its first tick on; before,
// the statuses may be of an earlier one.
template <class Tree>
Tally CountCompleted(Tree& tree, NodeIndex node) {
  Tally tally;
  if (tree.memory(node) == 0) tree.LeaveChildren(node);
  tree.memory(node) = 1;
  for (NodeIndex child = node + 1; child != tree.EndOf(node); child = tree.EndOf(child)) {
    if (IsCompleted(tree.status(child))) tally.Add(tree.status(child));
  }
  return tally;
}

}  // namespace internal

/// Throws std::invalid_argument if a threshold is higher than the number of children.
template <class Tree>
Status TickParallel(Tree& tree, NodeIndex node) {
  const int children = static_cast<int>(internal::CountChildren(tree, node));
  const int success_count = tree.template Port<int>(node, 0);
  const int to_succeed = internal::Threshold(success_count, children);
  const int to_fail = internal::Threshold(tree.template Port<int>(node, 1), children);
  internal::Tally tally = internal::CountCompleted(tree, node);
  for (NodeIndex child = node + 1; child != tree.EndOf(node); child = tree.EndOf(child)) {
    if (!IsCompleted(tree.status(child))) tally.Add(tree.Tick(child));
    const int successes = tally.success + (success_count < 0 ? tally.skipped : 0);
    if (successes >= to_succeed) return internal::End(tree, node, Status::kSuccess);
    if (children - tally.failure < to_succeed || tally.failure == to_fail) {
      return internal::End(tree, node, Status::kFailure);
    }
  }
  if (tally.running > 0) return Status::kRunning;
  if (tally.skipped == children) return internal::PassOn(tree, node, Status::kSkipped);
  return internal::End(tree, node, tally.failure > 0 ? Status::kFailure : Status::kSuccess);
}

/// Throws std::invalid_argument if max_failures is higher than the number of children.
template <class Tree>
Status TickParallelAll(Tree& tree, NodeIndex node) {
  const int children = static_cast<int>(internal::CountChildren(tree, node));
  const int to_fail = internal::Threshold(tree.template Port<int>(node, 0), children);
  internal::Tally tally = internal::CountCompleted(tree, node);
  for (NodeIndex child = node + 1; child != tree.EndOf(node); child = tree.EndOf(child)) {
    if (!IsCompleted(tree.status(child))) tally.Add(tree.Tick(child));
  }
  if (tally.running > 0) return Status::kRunning;
  if (tally.skipped == children) return internal::PassOn(tree, node, Status::kSkipped);
  return internal::End(tree, node, tally.failure >= to_fail ? Status::kFailure : Status::kSuccess);
}

/// All children, those that have completed too, in every tick: for monitors, where the answer to
/// "is all well?" is that of the worst part. Halts what still runs when the answer is FAILURE.
template <class Tree>
Status TickWorstOf(Tree& tree, NodeIndex node) {
  internal::Tally tally;
  for (NodeIndex child = node + 1; child != tree.EndOf(node); child = tree.EndOf(child)) {
    tally.Add(tree.Tick(child));
  }
  if (tally.failure > 0) return internal::End(tree, node, Status::kFailure);
  if (tally.running > 0) return Status::kRunning;
  return internal::End(tree, node, tally.success > 0 ? Status::kSuccess : Status::kSkipped);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_PARALLEL_H_
