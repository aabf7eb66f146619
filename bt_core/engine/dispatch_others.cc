// The ticks of the built-in nodes that are not in the innermost loop (tick.cc has those).
#include "bt_core/engine/executor.h"
#include "bt_core/nodes/blackboard_nodes.h"
#include "bt_core/nodes/breaker.h"
#include "bt_core/nodes/conditional.h"
#include "bt_core/nodes/filter.h"
#include "bt_core/nodes/loop.h"
#include "bt_core/nodes/once.h"
#include "bt_core/nodes/parallel.h"
#include "bt_core/nodes/pipeline.h"
#include "bt_core/nodes/random.h"
#include "bt_core/nodes/rate.h"
#include "bt_core/nodes/recovery.h"
#include "bt_core/nodes/resume.h"
#include "bt_core/nodes/retry.h"
#include "bt_core/nodes/script_nodes.h"
#include "bt_core/nodes/switch.h"
#include "bt_core/nodes/test_node.h"
#include "bt_core/nodes/timing.h"
#include "bt_core/nodes/try_catch.h"

namespace coppice {
namespace {

bool KeepsMemoryWhenSkipped(NodeType type) {
  switch (type) {
    case NodeType::kRepeat:
    case NodeType::kRetryUntilSuccessful:
    case NodeType::kLoopInt:
    case NodeType::kLoopBool:
    case NodeType::kLoopDouble:
    case NodeType::kLoopString:
    case NodeType::kDelay:
      return true;
    default:
      return false;
  }
}

}  // namespace

// Of a node that is skipped: see halt.cc.
void Executor::KeepSomeMemory(NodeIndex node) {
  if (!KeepsMemoryWhenSkipped(nodes_[node].type)) memory_[node] = 0;
  if (memory_[node] != 0) ChangeKept(1);
}

Status Executor::DispatchOthers(NodeIndex node, NodeType type) {
  switch (type) {
    case NodeType::kAsyncSequence:
      return TickAsyncSequence(*this, node);
    case NodeType::kAsyncFallback:
      return TickAsyncFallback(*this, node);
    case NodeType::kSequenceWithMemory:
      return TickSequenceWithMemory(*this, node);
    case NodeType::kPersistentSequence:
      return TickPersistentSequence(*this, node);
    case NodeType::kParallel:
      return TickParallel(*this, node);
    case NodeType::kParallelAll:
      return TickParallelAll(*this, node);
    case NodeType::kWorstOf:
      return TickWorstOf(*this, node);
    case NodeType::kPipelineSequence:
      return TickPipelineSequence(*this, node);
    case NodeType::kNonblockingSequence:
      return TickNonblockingSequence(*this, node);
    case NodeType::kIfThenElse:
      return TickIfThenElse(*this, node);
    case NodeType::kWhileDoElse:
      return TickWhileDoElse(*this, node);
    case NodeType::kSwitchN:
      return TickSwitchN(*this, node);
    case NodeType::kSwitch:
      return TickSwitch(*this, node);
    case NodeType::kTryCatch:
      return TickTryCatch(*this, node);
    case NodeType::kRecoveryNode:
      return TickRecoveryNode(*this, node);
    case NodeType::kRoundRobin:
      return TickRoundRobin(*this, node);
    case NodeType::kRandomSequence:
      return TickRandomSequence(*this, node);
    case NodeType::kRandomSelector:
      return TickRandomSelector(*this, node);
    case NodeType::kRepeat:
      return TickRepeat(*this, node);
    case NodeType::kRetryUntilSuccessful:
      return TickRetryUntilSuccessful(*this, node);
    case NodeType::kKeepRunningUntilFailure:
      return TickKeepRunningUntilFailure(*this, node);
    case NodeType::kLoopInt:
      return TickLoopInt(*this, node);
    case NodeType::kLoopBool:
      return TickLoopBool(*this, node);
    case NodeType::kLoopDouble:
      return TickLoopDouble(*this, node);
    case NodeType::kLoopString:
      return TickLoopString(*this, node);
    case NodeType::kTimeout:
      return TickTimeout(*this, node);
    case NodeType::kDelay:
      return TickDelay(*this, node);
    case NodeType::kRunOnce:
      return TickRunOnce(*this, node);
    case NodeType::kSingleTrigger:
      return TickSingleTrigger(*this, node);
    case NodeType::kRateController:
      return TickRateController(*this, node);
    case NodeType::kCooldown:
      return TickCooldown(*this, node);
    case NodeType::kCircuitBreaker:
      return TickCircuitBreaker(*this, node);
    case NodeType::kConsecutive:
      return TickConsecutive(*this, node);
    case NodeType::kDebounce:
      return TickDebounce(*this, node);
    case NodeType::kPrecondition:
      return TickPrecondition(*this, node);
    case NodeType::kSkipUnlessUpdated:
      return TickSkipUnlessUpdated(*this, node);
    case NodeType::kWaitValueUpdate:
      return TickWaitValueUpdate(*this, node);
    case NodeType::kSleep:
      return TickSleep(*this, node);
    case NodeType::kScript:
      return TickScript(*this, node);
    case NodeType::kSetBlackboard:
      return TickSetBlackboard(*this, node);
    case NodeType::kUnsetBlackboard:
      return TickUnsetBlackboard(*this, node);
    case NodeType::kWasEntryUpdated:
      return TickWasEntryUpdated(*this, node);
    case NodeType::kHysteresis:
      return TickHysteresis(*this, node);
    case NodeType::kTestNode:
      return TickTestNode(*this, node);
    default:
      throw std::logic_error("no such node");  // tick.cc has all others
  }
}

}  // namespace coppice
