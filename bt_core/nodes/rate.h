// Decorators that keep a child from running too often.
//
//   node             child SUCCESS or FAILURE    RUNNING    SKIPPED     before the time is over
//   RateController   passed on; the period       RUNNING    SKIPPED     RUNNING
//                    begins
//   Cooldown         passed on; the time begins  RUNNING    SKIPPED     the port `if_cooling`
//
// RateController counts only while it is ticked in every tick: after a halt, or a tick without it,
// the child is ticked at once. A running child is ticked in every tick. Cooldown counts always.
// Source: Nav2 for RateController, which starts no period after a failure, so that a child that
// fails is not held back at all.
#ifndef COPPICE_BT_CORE_NODES_RATE_H_
#define COPPICE_BT_CORE_NODES_RATE_H_

#include <chrono>
#include <cstdint>
#include <stdexcept>

#include "bt_core/base/clock.h"
#include "bt_core/nodes/children.h"
#include "bt_core/nodes/result_port.h"

namespace coppice {
namespace internal {

// The result of a child that is not ticked before a point in time.
template <class Tree>
Status HeldBack(Tree& tree, Time until, Status result) {
  if (result == Status::kRunning) tree.WakeAt(until);
  return result;
}

}  // namespace internal

/// Throws std::invalid_argument if the rate is not positive. Own slot 0: time at which the period
/// began. Own slot 1: number of the tick in which the node has ended, 0 while it is RUNNING.
template <class Tree>
Status TickRateController(Tree& tree, NodeIndex node) {
  const double hz = tree.template Port<double>(node, 0);
  if (!(hz > 0)) throw std::invalid_argument("hz must be more than 0");
  std::int64_t& began = tree.template Own<std::int64_t>(node, 1);
  std::uint64_t& ended_at = tree.template Own<std::uint64_t>(node, 2);
  std::uint64_t& memory = tree.memory(node);  // 1: waits in this activation
  const bool goes_on = memory != 0 || (ended_at != 0 && ended_at + 1 >= tree.ticks());
  const std::chrono::duration<double> period(1 / hz);
  const Time until = TimeFromNanoseconds(began) + std::chrono::duration_cast<Duration>(period);
  const bool child_runs = tree.status(node + 1) == Status::kRunning;
  ended_at = 0;
  if (goes_on && !child_runs && tree.now() < until) {
    memory = 1;
    return internal::HeldBack(tree, until, Status::kRunning);
  }
  const Status result = tree.Tick(node + 1);
  if (result == Status::kRunning) return result;
  if (IsCompleted(result)) {
    began = ToNanoseconds(tree.now());
    ended_at = tree.ticks();
  }
  return internal::PassOn(tree, node, result);
}

/// Own slot 0: time at which the child may run again.
template <class Tree>
Status TickCooldown(Tree& tree, NodeIndex node) {
  std::int64_t& until = tree.template Own<std::int64_t>(node, 2);
  const bool child_runs = tree.status(node + 1) == Status::kRunning;
  if (!child_runs && tree.now() < TimeFromNanoseconds(until)) {
    return internal::HeldBack(tree, TimeFromNanoseconds(until),
                              internal::ResultPort(tree, node, 1));
  }
  const Status result = tree.Tick(node + 1);
  if (result == Status::kRunning) return result;
  if (IsCompleted(result)) {
    const std::chrono::milliseconds time(tree.template Port<unsigned>(node, 0));
    until = ToNanoseconds(tree.now() + time);
  }
  return internal::PassOn(tree, node, result);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_RATE_H_
