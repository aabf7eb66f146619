// RandomSequence and RandomSelector: as Sequence and Fallback, but each activation has an order of
// its own.
//
// Where a child stands is a hash of the port `seed`, the number of the activation and the number of
// the child, so all orders are equally likely, nothing but a counter is kept, and the same seed
// gives the same run again.
//
//   node             SUCCESS           FAILURE           RUNNING                    SKIPPED
//   RandomSequence   next in order     reset, FAILURE    RUNNING; resumes at this   next in order
//   RandomSelector   reset, SUCCESS    next in order     child                      next in order
//
// SKIPPED if all children were skipped. Source of the hash: Steele, Lea, Flood, "Fast splittable
// pseudorandom number generators", 2014 (SplitMix64).
#ifndef COPPICE_BT_CORE_NODES_RANDOM_H_
#define COPPICE_BT_CORE_NODES_RANDOM_H_

#include <cstdint>
#include <utility>

#include "bt_core/nodes/children.h"

namespace coppice {
namespace internal {

inline std::uint64_t Mix(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

// The order of the children in one activation.
class Shuffle {
 public:
  using Place = std::pair<std::uint64_t, NodeIndex>;  // hash, then child to break a tie

  Shuffle(std::uint64_t seed, std::uint64_t activation) : key_(Mix(Mix(seed) + activation)) {}

  Place PlaceOf(std::uint32_t number, NodeIndex child) const { return {Mix(key_ + number), child}; }

  /// The first child if `after` is the end of the node, else the one behind it; the end of the node
  /// if there is none.
  template <class Tree>
  NodeIndex Next(const Tree& tree, NodeIndex node, NodeIndex after) const {
    Place bound{0, 0};
    std::uint32_t number = 0;
    for (NodeIndex child = node + 1; child != tree.EndOf(node); child = tree.EndOf(child)) {
      if (child == after) bound = PlaceOf(number, child);
      ++number;
    }
    Place best{UINT64_MAX, tree.EndOf(node)};
    number = 0;
    for (NodeIndex child = node + 1; child != tree.EndOf(node); child = tree.EndOf(child)) {
      const Place place = PlaceOf(number++, child);
      if (place > bound && place < best) best = place;
    }
    return best.second;
  }

 private:
  std::uint64_t key_;
};

// Own slot 0: number of activations. Memory: the child to resume at, and whether one was not
// skipped.
template <Status kGoOn, class Tree>
Status TickShuffled(Tree& tree, NodeIndex node) {
  constexpr std::uint64_t kNotAllSkipped = std::uint64_t{1} << 63;
  const NodeIndex end = tree.EndOf(node);
  std::uint64_t& memory = tree.memory(node);
  std::uint64_t& activations = tree.template Own<std::uint64_t>(node, 1);
  if (memory == 0) ++activations;
  const Shuffle order(tree.template Port<std::uint64_t>(node, 0), activations);
  bool went_on = (memory & kNotAllSkipped) != 0;
  auto child = static_cast<NodeIndex>(memory);
  if (child == 0) child = order.Next(tree, node, end);
  for (; child != end; child = order.Next(tree, node, child)) {
    const Status result = tree.Tick(child);
    if (result == Status::kRunning) {
      memory = child | (went_on ? kNotAllSkipped : 0);
      return result;
    }
    if (result != kGoOn && result != Status::kSkipped) return End(tree, node, result);
    went_on |= result == kGoOn;
  }
  return End(tree, node, went_on ? kGoOn : Status::kSkipped);
}

}  // namespace internal

template <class Tree>
Status TickRandomSequence(Tree& tree, NodeIndex node) {
  return internal::TickShuffled<Status::kSuccess>(tree, node);
}

template <class Tree>
Status TickRandomSelector(Tree& tree, NodeIndex node) {
  return internal::TickShuffled<Status::kFailure>(tree, node);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_RANDOM_H_
