// Sequences that tick children again that have completed already, in every tick.
//
//   node                 SUCCESS       FAILURE           RUNNING                       SKIPPED
//   PipelineSequence     next child    reset, FAILURE    RUNNING, unless a child       next child
//                                                        behind it has been RUNNING
//                                                        in this activation: next
//   NonblockingSequence  next child    reset, FAILURE    next child                    next child
//
// At the end: PipelineSequence SUCCESS, halting what runs; NonblockingSequence RUNNING if a child
// is, else SUCCESS. Both SKIPPED if all children were skipped in this tick. Source: Nav2.
#ifndef COPPICE_BT_CORE_NODES_PIPELINE_H_
#define COPPICE_BT_CORE_NODES_PIPELINE_H_

#include "bt_core/nodes/children.h"

namespace coppice {

/// Memory: the last child, in document order, that was RUNNING.
template <class Tree>
Status TickPipelineSequence(Tree& tree, NodeIndex node) {
  bool all_skipped = true;
  for (NodeIndex child = node + 1; child != tree.EndOf(node); child = tree.EndOf(child)) {
    const Status result = tree.Tick(child);
    if (result == Status::kFailure) return internal::End(tree, node, result);
    if (result == Status::kRunning && child >= tree.memory(node)) {
      tree.memory(node) = child;
      return result;
    }
    all_skipped &= result == Status::kSkipped;
  }
  return internal::End(tree, node, all_skipped ? Status::kSkipped : Status::kSuccess);
}

template <class Tree>
Status TickNonblockingSequence(Tree& tree, NodeIndex node) {
  bool all_skipped = true;
  bool is_running = false;
  for (NodeIndex child = node + 1; child != tree.EndOf(node); child = tree.EndOf(child)) {
    const Status result = tree.Tick(child);
    if (result == Status::kFailure) return internal::End(tree, node, result);
    all_skipped &= result == Status::kSkipped;
    is_running |= result == Status::kRunning;
  }
  if (is_running) return Status::kRunning;
  return internal::End(tree, node, all_skipped ? Status::kSkipped : Status::kSuccess);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_PIPELINE_H_
