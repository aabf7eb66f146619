// Nodes that write the blackboard or look whether somebody has written it. Their ports take keys of
// any type.
//
//   SetBlackboard      copies `value`, a literal or a key, to the key `output_key`; FAILURE if the
//                      value's key is empty, else SUCCESS
//   UnsetBlackboard    empties a key; SUCCESS
//   WasEntryUpdated    SUCCESS if the key was written since this node was last ticked, or ever if
//                      this is the first time; else FAILURE
//   SkipUnlessUpdated  the same question; yes: ticks the child, no: SKIPPED
//   WaitValueUpdate    the same question; yes: ticks the child, no: RUNNING
//
// The decorators pass on what their child returns and do not ask while it is RUNNING. A key that is
// empty was not updated. Source: BehaviorTree.CPP 4.
#ifndef COPPICE_BT_CORE_NODES_BLACKBOARD_NODES_H_
#define COPPICE_BT_CORE_NODES_BLACKBOARD_NODES_H_

#include <cstdint>

#include "bt_core/data/blackboard.h"
#include "bt_core/nodes/children.h"

namespace coppice {
namespace internal {

/// Copies a value to a slot; `type` is that of the ports that share the slot, null for any. A value
/// of another type is converted to it through its text. Throws std::invalid_argument if that cannot
/// be done. A slot of any type keeps the type of the value that it holds, if that can be done.
void CopyTo(Slot& slot, const Type* type, const Value& value);

// Port 0 is the entry. Own slot 0: 1 + the number of writes that was seen last.
template <class Tree>
bool WasUpdated(Tree& tree, NodeIndex node) {
  const Slot& entry = *tree.SlotOf(node, 0);
  if (!entry.value.has_value()) return false;
  std::uint64_t& seen = tree.template Own<std::uint64_t>(node, 1);
  const std::uint64_t before = seen;
  seen = std::uint64_t{1} + entry.writes;
  return seen != before;
}

template <class Tree>
Status TickIfUpdated(Tree& tree, NodeIndex node, Status otherwise) {
  const bool child_runs = tree.status(node + 1) == Status::kRunning;
  if (!child_runs && !WasUpdated(tree, node)) return otherwise;
  return PassOn(tree, node, tree.Tick(node + 1));
}

}  // namespace internal

template <class Tree>
Status TickSetBlackboard(Tree& tree, NodeIndex node) {
  const Slot& from = *tree.SlotOf(node, 0);
  if (!from.value.has_value()) return Status::kFailure;
  internal::CopyTo(*tree.SlotOf(node, 1), tree.TypeOfPort(node, 1), from.value);
  tree.SlotOf(node, 1)->CountWrite(tree.now());
  return Status::kSuccess;
}

template <class Tree>
Status TickUnsetBlackboard(Tree& tree, NodeIndex node) {
  Slot& slot = *tree.SlotOf(node, 0);
  slot.value.Reset();
  slot.CountWrite(tree.now());
  return Status::kSuccess;
}

template <class Tree>
Status TickWasEntryUpdated(Tree& tree, NodeIndex node) {
  return internal::WasUpdated(tree, node) ? Status::kSuccess : Status::kFailure;
}

template <class Tree>
Status TickSkipUnlessUpdated(Tree& tree, NodeIndex node) {
  return internal::TickIfUpdated(tree, node, Status::kSkipped);
}

template <class Tree>
Status TickWaitValueUpdate(Tree& tree, NodeIndex node) {
  return internal::TickIfUpdated(tree, node, Status::kRunning);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_BLACKBOARD_NODES_H_
