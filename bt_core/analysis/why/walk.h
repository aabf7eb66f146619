// The walk of one tick: who was ticked in which order, by whom and with what result. Made from the
// events alone, so it is right for every kind of node, also for those of the user.
//
//   const Walk walk = WalkOf(shape, events.words);
//   for (const WalkStep& step : walk.steps) ...   // the root first, then as the tick went
#ifndef COPPICE_BT_CORE_ANALYSIS_WHY_WALK_H_
#define COPPICE_BT_CORE_ANALYSIS_WHY_WALK_H_

#include <cstdint>
#include <vector>

#include "bt_core/engine/events/event_words.h"
#include "bt_core/engine/events/status_follower.h"

namespace coppice {

using StepIndex = std::uint32_t;
inline constexpr StepIndex kNoStep = UINT32_MAX;

/// One tick of one node, or that it was made idle on its own.
struct WalkStep {
  NodeIndex node;
  Status result;        ///< kIdle: it was halted, or made idle while its parent goes on
  StepIndex parent;     ///< who ticked it; kNoStep for the root, and within a halt
  StepIndex end;        ///< one past the last step below it: steps lie in preorder
  std::uint32_t entry;  ///< Walk::events that had happened when it was entered
  std::uint32_t event;  ///< the event of its result
  bool is_injected;     ///< somebody outside put the result in place of the node's own
};

struct Walk {
  std::vector<Event> events;  ///< all of the tick; their bytes lie in the words
  std::vector<WalkStep> steps;

  /// The last step of a node in this tick; kNoStep if it was not ticked. Resets do not count.
  StepIndex LastStepOf(NodeIndex node) const;

  /// The steps directly below a step, in order.
  std::vector<StepIndex> ChildrenOf(StepIndex step) const;

  /// The child whose result made that of its parent: the last one with the same result, else the
  /// last one (an Inverter's); kNoStep if it ticked none.
  StepIndex Decisive(StepIndex step) const;
};

/// Nodes that there are not are left out; with the statuses before the tick, so are resets that
/// change nothing. The words must live as long as the walk.
Walk WalkOf(const TreeShape& shape, EventWords words, const std::vector<Status>* before = nullptr);

/// The first step, in order of completion, whose node returned something else in `before` or was
/// not ticked there; kNoStep if there is none. Resets do not count.
StepIndex FirstDifference(const Walk& walk, const Walk& before);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_WHY_WALK_H_
