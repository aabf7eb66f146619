// Nodes for recoveries.
//
//   RecoveryNode   SUCCESS             FAILURE                          RUNNING   SKIPPED
//   first child    SUCCESS             ticks the second child; FAILURE  RUNNING   SKIPPED
//                                      after the last retry
//   second child   counts a retry and  FAILURE                          RUNNING   FAILURE
//                  yields, then the
//                  first child again
//
// To yield is to return RUNNING and ask for the next tick at once: a pair of fast children cannot
// keep the rest of the tree waiting. What resets the number of retries: every result but RUNNING,
// and a halt.
//
//   RoundRobin     SUCCESS             FAILURE                          RUNNING   SKIPPED
//   its child      SUCCESS; the next   next child; FAILURE after the    RUNNING   next child
//                  activation starts   last
//                  at the next child
//
// RoundRobin's last child is the last in document order, or with wrap_around the one before the
// child that it began with. SKIPPED if all that it ticked in this activation were skipped. After
// its end without success, after a success of the last child and after a halt it starts at the
// first child.
//
// Source: the nodes of these names in Nav2, whose RecoveryNode runs all retries in one tick and
// keeps the number of retries when the recovery is skipped, and whose RoundRobin loses the success
// of the last child.
#ifndef COPPICE_BT_CORE_NODES_RECOVERY_H_
#define COPPICE_BT_CORE_NODES_RECOVERY_H_

#include <cstdint>

#include "bt_core/nodes/children.h"

namespace coppice {
namespace internal {

constexpr std::uint64_t kRecovering = std::uint64_t{1} << 63;  // the second child's turn
constexpr std::uint64_t kNotAllSkipped = std::uint64_t{1} << 63;

}  // namespace internal

/// Memory: number of retries, and kRecovering.
template <class Tree>
Status TickRecoveryNode(Tree& tree, NodeIndex node) {
  std::uint64_t& memory = tree.memory(node);
  if ((memory & internal::kRecovering) == 0) {
    const Status result = tree.Tick(node + 1);
    if (result == Status::kRunning) return result;
    const auto retries = static_cast<std::int64_t>(memory);
    if (result != Status::kFailure || retries >= tree.template Port<int>(node, 0)) {
      return internal::End(tree, node, result);
    }
    tree.ResetChildren(node);
    memory |= internal::kRecovering;
  }
  const Status result = tree.Tick(tree.EndOf(node + 1));
  if (result == Status::kRunning) return result;
  if (result != Status::kSuccess) return internal::End(tree, node, Status::kFailure);
  tree.ResetChildren(node);
  memory = (memory & ~internal::kRecovering) + 1;
  tree.TickAgain();
  return Status::kRunning;
}

/// Own slot 0: number of the child that the next activation starts at. Memory: the number of
/// children done in this activation in the high half, 1 + the number of the current child in the
/// low half, and kNotAllSkipped.
template <class Tree>
Status TickRoundRobin(Tree& tree, NodeIndex node) {
  std::uint64_t& start = tree.template Own<std::uint64_t>(node, 1);
  std::uint64_t& memory = tree.memory(node);
  const bool wraps = tree.template Port<bool>(node, 0);
  const std::uint32_t children = internal::CountChildren(tree, node);
  bool not_all_skipped = (memory & internal::kNotAllSkipped) != 0;
  auto done = static_cast<std::uint32_t>((memory & ~internal::kNotAllSkipped) >> 32);
  auto current = memory != 0 ? static_cast<std::uint32_t>(memory) - 1
                             : static_cast<std::uint32_t>(start % children);
  start = 0;
  for (; done < children; ++done) {
    const Status result = tree.Tick(internal::ChildAt(tree, node, current));
    if (result == Status::kRunning) {
      memory = (std::uint64_t{done} << 32) | (current + 1) |
               (not_all_skipped ? internal::kNotAllSkipped : 0);
      return result;
    }
    current = (current + 1) % children;
    if (result == Status::kSuccess) {
      start = current;
      return internal::End(tree, node, result);
    }
    not_all_skipped |= result == Status::kFailure;
    if (current == 0 && !wraps) break;
  }
  return internal::End(tree, node, not_all_skipped ? Status::kFailure : Status::kSkipped);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_RECOVERY_H_
