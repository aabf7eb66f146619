#include "bt_core/data/standard_types.h"
#include "bt_core/nodes/breaker.h"
#include "bt_core/nodes/built_in_tables.h"
#include "bt_core/script/script.h"

namespace coppice {

using tables::Any;
using tables::In;
using tables::Own;

namespace {

BuiltIn Decorator(NodeType type, std::string id, std::string description,
                  std::vector<PortDeclaration> ports = {}) {
  return tables::Node(type, NodeCategory::kDecorator, tables::kOne, std::move(id),
                      std::move(description), std::move(ports));
}

template <class T>
BuiltIn Loop(NodeType type, std::string id) {
  return Decorator(type, std::move(id), "Runs its child once for each element of a list.",
                   {In<std::vector<T>>("queue", "the elements, separated by ; or a key"),
                    In<Status>("if_empty", "result when no element is left", "SUCCESS"),
                    tables::Out<T>("value", "where each element is written")});
}

}  // namespace

std::vector<BuiltIn> BuiltInDecorators() {
  return {
      Decorator(NodeType::kInverter, "Inverter", "Turns success into failure and back."),
      Decorator(NodeType::kForceSuccess, "ForceSuccess", "Succeeds whatever its child does."),
      Decorator(NodeType::kForceFailure, "ForceFailure", "Fails whatever its child does."),
      tables::Node(NodeType::kSubTree, NodeCategory::kSubTree, tables::kNone, "SubTree",
                   "Runs another tree with a blackboard scope of its own.", {}),
      Decorator(NodeType::kRepeat, "Repeat",
                "Runs its child again and again while it succeeds. Yields after every cycle.",
                {In<int>("num_cycles", "how often; -1 = for ever")}),
      Decorator(NodeType::kRetryUntilSuccessful, "RetryUntilSuccessful",
                "Runs its child again while it fails. Yields after every attempt.",
                {In<int>("num_attempts", "how often; -1 = for ever")}),
      Decorator(NodeType::kKeepRunningUntilFailure, "KeepRunningUntilFailure",
                "Runs its child again in every tick until it fails."),
      Loop<int>(NodeType::kLoopInt, "LoopInt"),
      Loop<bool>(NodeType::kLoopBool, "LoopBool"),
      Loop<double>(NodeType::kLoopDouble, "LoopDouble"),
      Loop<std::string>(NodeType::kLoopString, "LoopString"),
      Decorator(NodeType::kTimeout, "Timeout", "Halts its child and fails when it takes too long.",
                {In<unsigned>("msec", "limit [ms]; 0 = none")}),
      Decorator(NodeType::kDelay, "Delay", "Waits, then ticks its child.",
                {In<unsigned>("delay_msec", "how long to wait [ms]")}),
      Decorator(NodeType::kRunOnce, "RunOnce", "Runs its child until it has completed once.",
                {In<bool>("then_skip", "afterwards SKIPPED, else the result of the child", "true"),
                 Own<std::uint64_t>("result of the child")}),
      Decorator(NodeType::kSingleTrigger, "SingleTrigger",
                "Runs its child once, then fails for as long as it is ticked in every tick.",
                {Own<std::uint64_t>("tick in which it was done")}),
      Decorator(NodeType::kRateController, "RateController", "Starts its child at a limited rate.",
                {In<double>("hz", "how often at most [1/s]", "10"),
                 Own<std::int64_t>("time at which the period began [ns]"),
                 Own<std::uint64_t>("tick in which it has ended")}),
      Decorator(NodeType::kCooldown, "Cooldown",
                "Does not start its child for some time after it has completed.",
                {In<unsigned>("msec", "how long [ms]"),
                 In<Status>("if_cooling", "result during that time", "FAILURE"),
                 Own<std::int64_t>("time at which the child may run again [ns]")}),
      Decorator(NodeType::kCircuitBreaker, "CircuitBreaker",
                "Does not start its child for some time after it has failed too often.",
                {In<unsigned>("max_failures", "failures that open it", "3"),
                 In<unsigned>("period_msec", "within this time [ms]", "60000"),
                 In<unsigned>("open_msec", "how long it stays open [ms]", "30000"),
                 In<Status>("if_open", "result while it is open", "FAILURE"),
                 Own<FailureTimes>("failures within the period [ns]"),
                 Own<std::uint64_t>("time until which it is open [ns] + 1")}),
      Decorator(NodeType::kConsecutive, "Consecutive",
                "Changes its answer when its child has contradicted it several times in a row.",
                {In<unsigned>("successes", "successes that make it succeed", "2"),
                 In<unsigned>("failures", "failures that make it fail", "2"),
                 In<Status>("initial", "the first answer", "FAILURE"),
                 Own<std::uint64_t>("the answer"), Own<std::uint64_t>("contradictions in a row")}),
      Decorator(
          NodeType::kDebounce, "Debounce",
          "Changes its answer when its child has contradicted it for some time.",
          {In<unsigned>("success_msec", "time to become SUCCESS [ms]", "0"),
           In<unsigned>("failure_msec", "time to become FAILURE [ms]", "0"),
           In<Status>("initial", "the first answer", "FAILURE"), Own<std::uint64_t>("the answer"),
           Own<std::uint64_t>("time of the first contradiction [ns] + 1")}),
      Decorator(NodeType::kPrecondition, "Precondition", "Ticks its child if a script says so.",
                {In<ScriptCode>("if", "is asked when the child is not running"),
                 In<Status>("else", "result if the script says no", "FAILURE")}),
      Decorator(
          NodeType::kSkipUnlessUpdated, "SkipUnlessUpdated",
          "Ticks its child if a key was written; else it is skipped.",
          {Any(PortDirection::kInput, "entry", "the key"), Own<std::uint64_t>("writes seen + 1")}),
      Decorator(
          NodeType::kWaitValueUpdate, "WaitValueUpdate",
          "Waits until a key is written, then ticks its child.",
          {Any(PortDirection::kInput, "entry", "the key"), Own<std::uint64_t>("writes seen + 1")}),
  };
}

}  // namespace coppice
