// Nodes that keep a noisy answer from flickering. Each has a current answer, SUCCESS or FAILURE,
// which outlives its activations; at first it is that of the port `initial`, for Hysteresis
// FAILURE.
//
//   node         the answer becomes SUCCESS                 the answer becomes FAILURE
//   Consecutive  after `successes` SUCCESS of the child     after `failures` FAILURE of the child
//                in a row                                   in a row
//   Debounce     when the child has given nothing but       when it has given nothing but FAILURE
//                SUCCESS for `success_msec`                 for `failure_msec`
//   Hysteresis   when `value` is `high` or more             when `value` is `low` or less
//
// RUNNING and SKIPPED of the child are passed on and leave everything as it is. Debounce asks for a
// tick at the time at which the answer would change.
#ifndef COPPICE_BT_CORE_NODES_FILTER_H_
#define COPPICE_BT_CORE_NODES_FILTER_H_

#include <chrono>
#include <cstdint>
#include <stdexcept>

#include "bt_core/base/clock.h"
#include "bt_core/nodes/children.h"
#include "bt_core/nodes/result_port.h"

namespace coppice {
namespace internal {

// Ticks the child of a filter. Own slot k: the answer, 0 before the first; `initial` then.
template <class Tree>
Status TickFiltered(Tree& tree, NodeIndex node, std::uint32_t k, Status initial) {
  std::uint64_t& answer = tree.template Own<std::uint64_t>(node, k);
  if (answer == 0) answer = static_cast<std::uint64_t>(initial);
  return PassOn(tree, node, tree.Tick(node + 1));
}

}  // namespace internal

/// Own slot 0: the answer. Own slot 1: how often in a row the child has contradicted it.
template <class Tree>
Status TickConsecutive(Tree& tree, NodeIndex node) {
  const Status initial = internal::ResultPort(tree, node, 2);
  const Status result = internal::TickFiltered(tree, node, 3, initial);
  if (!IsCompleted(result)) return result;
  std::uint64_t& answer = tree.template Own<std::uint64_t>(node, 3);
  std::uint64_t& contradictions = tree.template Own<std::uint64_t>(node, 4);
  contradictions = result == static_cast<Status>(answer) ? 0 : contradictions + 1;
  const std::uint32_t port = result == Status::kSuccess ? 0 : 1;
  if (contradictions > 0 && contradictions >= tree.template Port<unsigned>(node, port)) {
    answer = static_cast<std::uint64_t>(result);
    contradictions = 0;
  }
  return static_cast<Status>(answer);
}

/// Own slot 0: the answer. Own slot 1: since when the child contradicts it, plus 1; 0 for not.
template <class Tree>
Status TickDebounce(Tree& tree, NodeIndex node) {
  const Status initial = internal::ResultPort(tree, node, 2);
  const Status result = internal::TickFiltered(tree, node, 3, initial);
  if (!IsCompleted(result)) return result;
  std::uint64_t& answer = tree.template Own<std::uint64_t>(node, 3);
  std::uint64_t& since = tree.template Own<std::uint64_t>(node, 4);
  if (result == static_cast<Status>(answer)) {
    since = 0;
    return result;
  }
  if (since == 0) since = static_cast<std::uint64_t>(ToNanoseconds(tree.now())) + 1;
  const std::uint32_t port = result == Status::kSuccess ? 0 : 1;
  const std::chrono::milliseconds needed(tree.template Port<unsigned>(node, port));
  const Time change = TimeFromNanoseconds(static_cast<std::int64_t>(since - 1)) + needed;
  if (tree.now() < change) {
    tree.WakeAt(change);
    return static_cast<Status>(answer);
  }
  answer = static_cast<std::uint64_t>(result);
  since = 0;
  return result;
}

/// Throws std::invalid_argument if low is more than high. Own slot 0: the answer.
template <class Tree>
Status TickHysteresis(Tree& tree, NodeIndex node) {
  const double value = tree.template Port<double>(node, 0);
  const double low = tree.template Port<double>(node, 1);
  const double high = tree.template Port<double>(node, 2);
  if (low > high) throw std::invalid_argument("low is more than high");
  bool& is_high = tree.template Own<bool>(node, 3);
  if (value >= high) is_high = true;
  if (value <= low) is_high = false;
  return is_high ? Status::kSuccess : Status::kFailure;
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_FILTER_H_
