// What the control nodes do in one tick.
//
// Written against a Tree that knows children, statuses and one 64-bit word of memory for each node:
// the executor, by way of the Tree in tick.cc for what this file has. A node's memory is zero when
// an activation starts and is cleared when it ends or is halted.
//
//   Status   Tick(node)               ticks a child and stores its status
//   void     Halt(node)               halts a running child and everything below it; makes it idle
//   void     ResetChildren(node)      makes all children idle, halting the running ones
//   void     ChildrenAreIdle(node)    at its end: resets what skipped children keep
//   void     LeaveChildren(node)      makes those idle that do not run; a skipped one keeps (below)
//   void     LetGo(node)              makes a skipped child forget that; idle if it kept some
//   Status   status(node)             of a child: RUNNING is always true, the other values only
//                                     where the node itself sees to it that children are reset
//   uint64&  memory(node)
//   NodeIndex EndOf(node)             one past its last descendant; node + 1 is its first child
//   const T& Port<T>(node, k)         the value of its k-th port; throws UnsetInput
//   bool     HasScript(node, k)       false for an optional one that the XML leaves out
//   Slot*    SlotOf(node, k)          the slot that the port is bound to; null if there is none
//   const Type* TypeOfPort(node, k)   the type of that slot; null if it takes any
//   T&       Own<T>(node, k)          a private slot, which outlives the activation; k counts on
//                                     behind the ports ("own slot 0" is the first one)
//   void     RunScript(node, k)       a port of type ScriptCode
//   bool     TestScript(node, k)
//   const ScriptConstants& constants()
//   Time     now()                    when this tick began
//   uint64   ticks()                  number of this tick, from 1
//   void     WakeAt(time)             asks for a tick at that time at the latest
//   void     TickAgain()              asks for the next tick at once
//
// SKIPPED does not end what a node has begun: a leaf that was RUNNING goes on when it is ticked
// again, and loops keep their rounds, unless the parent resets them, which halts such a leaf. So a
// node that passes SKIPPED on leaves its children, and one that goes on without them resets them.
//
// A skipped child counts as if it were not there; a control node all of whose children were skipped
// is skipped. Source of the names and rules: Colledanchise and Ögren, "Behavior Trees in Robotics
// and AI", 2018, chapter 1; BehaviorTree.CPP 4 for memory, reactivity and skipping.
#ifndef COPPICE_BT_CORE_NODES_CONTROL_H_
#define COPPICE_BT_CORE_NODES_CONTROL_H_

#include <cstdint>

#include "bt_core/base/status.h"
#include "bt_core/base/strong_index.h"

namespace coppice {

using NodeIndex = StrongIndex<struct NodeTag>;
inline constexpr NodeIndex kRootNode{0};
inline constexpr NodeIndex kNoNode{UINT32_MAX};

namespace internal {

// The result of a sequence or fallback whose last child was skipped.
template <Status kGoOn, class Tree>
[[gnu::noinline, gnu::cold]] Status UnlessAllWereSkipped(Tree tree, NodeIndex node) {
  for (NodeIndex child = node + 1; child != tree.EndOf(node); child = tree.EndOf(child)) {
    if (tree.status(child) == kGoOn) return kGoOn;
  }
  return Status::kSkipped;
}

// Sequence and Fallback are mirror images: `kGoOn` is the child's result after which the next one
// is ticked. Memory: the child to resume at.
template <Status kGoOn, class Tree>
inline Status TickWithMemory(Tree& tree, NodeIndex node) {
  const NodeIndex end = tree.EndOf(node);
  const auto resume_at = static_cast<NodeIndex>(tree.memory(node));
  NodeIndex child = resume_at != 0 ? resume_at : node + 1;
  Status result;
  for (;;) {
    result = tree.Tick(child);
    if (__builtin_expect(result != kGoOn, false) && result != Status::kSkipped) break;
    child = tree.EndOf(child);
    if (child != end) continue;
    if (result != kGoOn) result = UnlessAllWereSkipped<kGoOn>(tree, node);
    break;
  }
  if (result == Status::kRunning) {
    tree.memory(node) = child;
    return result;
  }
  tree.memory(node) = 0;
  tree.ChildrenAreIdle(node);
  return result;
}

// At most one child of a reactive node runs. Memory: that child.
template <Status kGoOn, class Tree>
inline Status TickReactive(Tree& tree, NodeIndex node) {
  const NodeIndex end = tree.EndOf(node);
  NodeIndex child = node + 1;
  Status result;
  for (;;) {
    result = tree.Tick(child);
    if (__builtin_expect(result != kGoOn, false)) {
      if (result != Status::kSkipped) break;
      tree.LetGo(child);
    }
    child = tree.EndOf(child);
    if (child != end) continue;
    if (result != kGoOn) result = UnlessAllWereSkipped<kGoOn>(tree, node);
    break;
  }
  // What ran behind this child is no longer wanted.
  const auto ran = static_cast<NodeIndex>(tree.memory(node));
  if (ran > child) tree.Halt(ran);
  if (result == Status::kRunning) {
    tree.memory(node) = child;
    return result;
  }
  tree.memory(node) = 0;
  tree.ChildrenAreIdle(node);
  return result;
}

}  // namespace internal

template <class Tree>
Status TickSequence(Tree& tree, NodeIndex node) {
  return internal::TickWithMemory<Status::kSuccess>(tree, node);
}

template <class Tree>
Status TickFallback(Tree& tree, NodeIndex node) {
  return internal::TickWithMemory<Status::kFailure>(tree, node);
}

template <class Tree>
Status TickReactiveSequence(Tree& tree, NodeIndex node) {
  return internal::TickReactive<Status::kSuccess>(tree, node);
}

template <class Tree>
Status TickReactiveFallback(Tree& tree, NodeIndex node) {
  return internal::TickReactive<Status::kFailure>(tree, node);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_CONTROL_H_
