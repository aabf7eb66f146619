// Guards and hooks (nodes/guards.h) of the nodes that have some.
#include <algorithm>

#include "bt_core/engine/executor.h"

namespace coppice {
namespace {

constexpr std::size_t Number(Guard guard) { return static_cast<std::size_t>(guard); }

}  // namespace

const GuardRecord& Executor::GuardsOf(NodeIndex node) const {
  return *std::lower_bound(program_->guards.begin(), program_->guards.end(), node,
                           [](const GuardRecord& guards, NodeIndex n) { return guards.node < n; });
}

// What the guards decide: kIdle if the node is to be ticked.
Status Executor::AskGuards(const GuardRecord& guards, NodeIndex node, bool running) {
  const auto test = [&](Guard guard, bool otherwise) {
    const ScriptIndex script = guards.scripts[Number(guard)];
    return script == kNoScript ? otherwise : program_->scripts[script].Test(blackboard_);
  };
  if (!running) {
    if (test(Guard::kFailureIf, false)) return Status::kFailure;
    if (test(Guard::kSuccessIf, false)) return Status::kSuccess;
    if (test(Guard::kSkipIf, false)) return Status::kSkipped;
    if (!test(Guard::kOnlyIf, true)) return Status::kSkipped;
  }
  if (test(Guard::kWhile, true)) {
    if (!running && !Keeps(node)) RunHook(guards, Guard::kOnStart);
    return Status::kIdle;
  }
  if (running) {
    HaltRunning(node);
  } else if (kept_ != 0) {
    LetGo(node);
  }
  return Status::kSkipped;
}

void Executor::RunHook(const GuardRecord& guards, Guard hook) {
  const ScriptIndex script = guards.scripts[Number(hook)];
  if (script != kNoScript) program_->scripts[script].Run(blackboard_);
}

void Executor::RunHaltedHook(NodeIndex node) {
  try {
    RunHook(GuardsOf(node), Guard::kOnHalted);
  } catch (...) {
    AddExceptionMessage(node);
  }
  reporter_.Writes(node);
}

Status Executor::TickGuarded(NodeIndex node, bool hooked) {
  const GuardRecord& guards = GuardsOf(node);
  try {
    const Status decided = AskGuards(guards, node, statuses_[node] == Status::kRunning);
    reporter_.Writes(node);
    const Status result = decided != Status::kIdle ? Store(node, decided)
                          : hooked                 ? TickHooked(node)
                                                   : TickAsItself(node);
    if (result == Status::kSuccess) RunHook(guards, Guard::kOnSuccess);
    if (result == Status::kFailure) RunHook(guards, Guard::kOnFailure);
    if (IsCompleted(result)) RunHook(guards, Guard::kPost);
    reporter_.Writes(node);
    return result;
  } catch (const Abort&) {
    throw;
  } catch (...) {  // a script threw
    if (statuses_[node] == Status::kRunning) HaltRunning(node);
    return Store(node, FailByException(node));
  }
}

}  // namespace coppice
