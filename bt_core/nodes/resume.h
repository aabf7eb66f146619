// Sequences and fallbacks that differ from the plain ones in where they resume or when they yield.
// Results of a child, mirrored for the fallback:
//
//   node                SUCCESS                 FAILURE                 RUNNING   SKIPPED
//   AsyncSequence       yields, then next       reset, FAILURE          RUNNING   next
//   AsyncFallback       reset, SUCCESS          yields, then next       RUNNING   next
//   SequenceWithMemory  yields, then next       reset, FAILURE;         RUNNING   next
//                                               resumes at this child
//   PersistentSequence  next                    reset, FAILURE          RUNNING   next
//
// To yield is to return RUNNING and ask for the next tick at once; only after a child that took one
// tick and is not the last. At the end SKIPPED if all children were skipped in this activation,
// else the result of the plain node. SequenceWithMemory keeps its place after a failure and after a
// halt, PersistentSequence keeps it on the blackboard and loses it only by FAILURE and SUCCESS.
// A failure of SequenceWithMemory does not halt what skipped children in front of its place have
// begun: that ends when the node comes to its end, is halted while it is RUNNING, or with the tree.
// Sources: BehaviorTree.CPP 4; Nav2 for PersistentSequence.
#ifndef COPPICE_BT_CORE_NODES_RESUME_H_
#define COPPICE_BT_CORE_NODES_RESUME_H_

#include <cstdint>
#include <stdexcept>
#include <string>

#include "bt_core/data/blackboard.h"
#include "bt_core/nodes/children.h"

namespace coppice {
namespace internal {

constexpr std::uint64_t kWentOn = std::uint64_t{1} << 63;  // a child has returned kGoOn

// Memory: the child to resume at, and kWentOn.
template <Status kGoOn, class Tree>
Status TickYielding(Tree& tree, NodeIndex node) {
  const NodeIndex end = tree.EndOf(node);
  std::uint64_t& memory = tree.memory(node);
  bool went_on = (memory & kWentOn) != 0;
  const auto resume_at = static_cast<NodeIndex>(memory);
  NodeIndex child = resume_at ? resume_at : node + 1;
  while (child != end) {
    const bool starts_now = tree.status(child) != Status::kRunning;
    const Status result = tree.Tick(child);
    const bool goes_on = result == kGoOn || result == Status::kSkipped;
    if (result != Status::kRunning && !goes_on) return End(tree, node, result);
    went_on |= result == kGoOn;
    if (goes_on) child = tree.EndOf(child);
    const bool yields = result == kGoOn && starts_now && child != end;
    if (yields) tree.TickAgain();
    if (yields || result == Status::kRunning) {
      memory = child | (went_on ? kWentOn : 0);
      return Status::kRunning;
    }
  }
  return End(tree, node, went_on ? kGoOn : Status::kSkipped);
}

}  // namespace internal

template <class Tree>
Status TickAsyncSequence(Tree& tree, NodeIndex node) {
  return internal::TickYielding<Status::kSuccess>(tree, node);
}

template <class Tree>
Status TickAsyncFallback(Tree& tree, NodeIndex node) {
  return internal::TickYielding<Status::kFailure>(tree, node);
}

namespace internal {

// Resets the child and those behind it. Those in front of it become idle, but end nothing.
template <class Tree>
Status FailInPlace(Tree& tree, NodeIndex node, NodeIndex child) {
  for (; child != tree.EndOf(node); child = tree.EndOf(child)) tree.Halt(child);
  tree.LeaveChildren(node);
  return Status::kFailure;
}

}  // namespace internal

/// Own slot 0: number of the child to resume at. Memory: 1 from the first tick on, and kWentOn.
template <class Tree>
Status TickSequenceWithMemory(Tree& tree, NodeIndex node) {
  const NodeIndex end = tree.EndOf(node);
  std::uint64_t& place = tree.template Own<std::uint64_t>(node, 0);
  std::uint64_t& memory = tree.memory(node);
  if (memory == 0) memory = 1 | (place > 0 ? internal::kWentOn : 0);
  NodeIndex child = internal::ChildAt(tree, node, place);
  while (child != end) {
    const bool starts_now = tree.status(child) != Status::kRunning;
    const Status result = tree.Tick(child);
    if (result == Status::kRunning) return result;
    if (result == Status::kFailure) return internal::FailInPlace(tree, node, child);
    ++place;
    child = tree.EndOf(child);
    if (result == Status::kSkipped) continue;
    memory |= internal::kWentOn;
    if (starts_now && child != end) {
      tree.TickAgain();
      return Status::kRunning;
    }
  }
  place = 0;
  const bool went_on = (memory & internal::kWentOn) != 0;
  return internal::End(tree, node, went_on ? Status::kSuccess : Status::kSkipped);
}

/// Port 0, of direction inout: number of the child to resume at; 0 if it has no value. Throws
/// std::invalid_argument if it is negative; a number behind the last child is the end. Memory: 1 +
/// the number of children skipped, and kWentOn.
template <class Tree>
Status TickPersistentSequence(Tree& tree, NodeIndex node) {
  Slot& slot = *tree.SlotOf(node, 0);
  int place = slot.value.has_value() ? slot.value.template Get<int>() : 0;
  if (place < 0) throw std::invalid_argument("there is no child " + std::to_string(place));
  const auto move_to = [&](int to) {
    slot.value.Set(to);
    slot.CountWrite(tree.now());
  };
  std::uint64_t& memory = tree.memory(node);
  if (memory == 0) memory = 1 | (place > 0 ? internal::kWentOn : 0);
  for (NodeIndex child = internal::ChildAt(tree, node, static_cast<std::uint64_t>(place));
       child != tree.EndOf(node); child = tree.EndOf(child)) {
    const Status result = tree.Tick(child);
    if (result == Status::kRunning) return result;
    move_to(result == Status::kFailure ? 0 : ++place);
    if (result == Status::kFailure) return internal::End(tree, node, result);
    memory = result == Status::kSkipped ? memory + 1 : memory | internal::kWentOn;
  }
  move_to(0);
  const bool all_skipped = memory == std::uint64_t{1} + internal::CountChildren(tree, node);
  return internal::End(tree, node, all_skipped ? Status::kSkipped : Status::kSuccess);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_RESUME_H_
