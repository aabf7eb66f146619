// TestNode: stands in for a leaf in a test of a tree. It waits for `async_delay`, then runs the
// script of its result and returns `return_status`.
//
//   return_status   success_script    failure_script    post_script
//   SUCCESS         runs              -                 runs, last
//   FAILURE         -                 runs              runs, last
//   SKIPPED         -                 -                 runs
//
// RUNNING until the delay is over; return_status="RUNNING" waits for ever. A halt runs no script.
// Source: BehaviorTree.CPP 4, where the same settings are made in C++ or JSON.
#ifndef COPPICE_BT_CORE_NODES_TEST_NODE_H_
#define COPPICE_BT_CORE_NODES_TEST_NODE_H_

#include "bt_core/nodes/result_port.h"
#include "bt_core/nodes/timing.h"

namespace coppice {

template <class Tree>
Status TickTestNode(Tree& tree, NodeIndex node) {
  const Time end = internal::EndOfWaiting(tree, node, tree.template Port<unsigned>(node, 1));
  if (tree.now() < end) {
    tree.WakeAt(end);
    return Status::kRunning;
  }
  const Status result = internal::ResultPort(tree, node, 0);
  if (result == Status::kRunning) return result;
  const auto run = [&](std::uint32_t k) {
    if (tree.HasScript(node, k)) tree.RunScript(node, k);
  };
  if (result == Status::kSuccess) run(2);
  if (result == Status::kFailure) run(3);
  run(4);
  return result;
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_TEST_NODE_H_
