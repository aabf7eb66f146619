// The built-in nodes: a closed set, so that they can be data in a flat array and dispatched by a
// switch. What they do is in the header of each group: control.h (Sequence, Fallback and their
// reactive forms), resume.h, parallel.h, pipeline.h, conditional.h, switch.h, try_catch.h,
// recovery.h, random.h, retry.h, loop.h, timing.h, rate.h, once.h, breaker.h, filter.h,
// script_nodes.h, blackboard_nodes.h and test_node.h.
#ifndef COPPICE_BT_CORE_NODES_NODE_TYPE_H_
#define COPPICE_BT_CORE_NODES_NODE_TYPE_H_

#include <cstdint>
#include <vector>

#include "bt_core/model/manifest.h"

namespace coppice {

enum class NodeType : std::uint8_t {
  kSequence,
  kFallback,
  kReactiveSequence,
  kReactiveFallback,
  kInverter,
  kForceSuccess,
  kForceFailure,
  kSubTree,
  kAlwaysSuccess,
  kAlwaysFailure,

  kAsyncSequence,
  kAsyncFallback,
  kSequenceWithMemory,
  kPersistentSequence,
  kParallel,
  kParallelAll,
  kWorstOf,
  kPipelineSequence,
  kNonblockingSequence,
  kIfThenElse,
  kWhileDoElse,
  kSwitchN,  ///< Switch2 .. Switch6
  kSwitch,
  kTryCatch,
  kRecoveryNode,
  kRoundRobin,
  kRandomSequence,
  kRandomSelector,

  kRepeat,
  kRetryUntilSuccessful,
  kKeepRunningUntilFailure,
  kLoopInt,
  kLoopBool,
  kLoopDouble,
  kLoopString,
  kTimeout,
  kDelay,
  kRunOnce,
  kSingleTrigger,
  kRateController,
  kCooldown,
  kCircuitBreaker,
  kConsecutive,
  kDebounce,
  kPrecondition,
  kSkipUnlessUpdated,
  kWaitValueUpdate,

  kSleep,
  kScript,
  kScriptCondition,
  kSetBlackboard,
  kUnsetBlackboard,
  kWasEntryUpdated,
  kHysteresis,
  kTestNode,

  kLeaf,     ///< user code
  kUser,     ///< a control node or decorator of a user's class
  kGuarded,  ///< not a node: what a node with guards or hooks is dispatched as
  kHooked,   ///< not a node: what a node is dispatched as that somebody wants to stop at
};

/// True for the nodes of the user's classes.
constexpr bool IsUserNode(NodeType type) {
  return type == NodeType::kLeaf || type == NodeType::kUser;
}

/// True for the nodes that remember by its number which child runs, and nothing else; the children
/// behind that one are idle.
constexpr bool RunsOneChild(NodeType type) {
  return type == NodeType::kSequence || type == NodeType::kFallback ||
         type == NodeType::kReactiveSequence || type == NodeType::kReactiveFallback;
}

/// How many children a node may have.
struct ChildCount {
  std::uint32_t min;
  std::uint32_t max;
};

struct BuiltIn {
  NodeType type;
  ChildCount children;
  Manifest manifest;  ///< with the private slots, as ports of direction kMailbox
};

/// Every built-in node. The order of ports is the order of Port(node, k) in the tick functions.
const std::vector<BuiltIn>& BuiltIns();

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_NODE_TYPE_H_
