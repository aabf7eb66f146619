#include "bt_core/nodes/built_in_tables.h"

namespace coppice {

using tables::Any;
using tables::In;
using tables::kSome;
using tables::Own;

namespace {

BuiltIn Control(NodeType type, std::string id, std::string description,
                std::vector<PortDeclaration> ports = {}, ChildCount children = kSome) {
  return tables::Node(type, NodeCategory::kControl, children, std::move(id), std::move(description),
                      std::move(ports));
}

BuiltIn SwitchOf(std::uint32_t cases) {
  const std::string count = std::to_string(cases);
  std::vector<PortDeclaration> ports = {
      Any(PortDirection::kInput, "variable", "the value that chooses the child")};
  ports.front().required = false;
  for (std::uint32_t k = 1; k <= cases; ++k) {
    const std::string number = std::to_string(k);
    ports.push_back(
        tables::MayIn<std::string>("case_" + number, "value for which child " + number + " runs"));
  }
  return Control(NodeType::kSwitchN, "Switch" + count,
                 "Ticks the child whose case matches the variable; the last child if none does.",
                 std::move(ports), {cases + 1, cases + 1});
}

}  // namespace

std::vector<BuiltIn> BuiltInControls() {
  return {
      Control(NodeType::kSequence, "Sequence",
              "Ticks its children in order while they succeed; resumes at the running child."),
      Control(NodeType::kFallback, "Fallback",
              "Ticks its children in order until one succeeds; resumes at the running child."),
      Control(
          NodeType::kReactiveSequence, "ReactiveSequence",
          "A Sequence that starts at the first child in every tick and halts what no longer runs."),
      Control(
          NodeType::kReactiveFallback, "ReactiveFallback",
          "A Fallback that starts at the first child in every tick and halts what no longer runs."),
      Control(NodeType::kAsyncSequence, "AsyncSequence",
              "A Sequence that yields after each child that succeeds at once."),
      Control(NodeType::kAsyncFallback, "AsyncFallback",
              "A Fallback that yields after each child that fails at once."),
      Control(NodeType::kSequenceWithMemory, "SequenceWithMemory",
              "A Sequence that resumes at the child that failed or was halted.",
              {Own<std::uint64_t>("number of the child to resume at")}),
      Control(NodeType::kPersistentSequence, "PersistentSequence",
              "A Sequence that keeps its place on the blackboard.",
              {{"current_child_idx", PortDirection::kInOut, &TypeOf<int>(),
                "number of the child to resume at, from 0", true, std::nullopt}}),
      Control(NodeType::kParallel, "Parallel",
              "Ticks all unfinished children in every tick; ends when enough succeeded or failed.",
              {In<int>("success_count", "successes that make it succeed; -1 = all children", "-1"),
               In<int>("failure_count", "failures that make it fail; -1 = all children", "1")}),
      Control(NodeType::kParallelAll, "ParallelAll",
              "Ticks all unfinished children in every tick until all have ended.",
              {In<int>("max_failures", "failures that make it fail; -1 = all children", "1")}),
      Control(NodeType::kWorstOf, "WorstOf",
              "Ticks all children in every tick; its result is the worst of theirs."),
      Control(NodeType::kPipelineSequence, "PipelineSequence",
              "A Sequence that ticks the children before the running one again in every tick."),
      Control(NodeType::kNonblockingSequence, "NonblockingSequence",
              "Ticks all children in every tick until all succeed in the same one."),
      Control(NodeType::kIfThenElse, "IfThenElse",
              "Ticks its second child if the first succeeds, else the third.", {}, {2, 3}),
      Control(NodeType::kWhileDoElse, "WhileDoElse",
              "Ticks its second child while the first succeeds, else the third.", {}, {2, 3}),
      SwitchOf(2),
      SwitchOf(3),
      SwitchOf(4),
      SwitchOf(5),
      SwitchOf(6),
      Control(NodeType::kSwitch, "Switch",
              "Ticks the child whose case matches the variable; the last child if none does.",
              {Any(PortDirection::kInput, "variable", "the value that chooses the child"),
               In<std::string>("cases", "a value for each child but the last, separated by ;")},
              {2, UINT32_MAX}),
      Control(NodeType::kTryCatch, "TryCatch",
              "A Sequence of all children but the last, which is ticked after a failure.",
              {In<bool>("catch_on_halt", "tick the last child also after a halt", "false")},
              {2, UINT32_MAX}),
      Control(NodeType::kRecoveryNode, "RecoveryNode",
              "Ticks its second child when the first fails, then the first again.",
              {In<int>("number_of_retries", "how often the first child is tried again", "1")},
              {2, 2}),
      Control(NodeType::kRoundRobin, "RoundRobin",
              "A Fallback that begins behind the child that succeeded last time.",
              {In<bool>("wrap_around", "go on with the first child behind the last", "false"),
               Own<std::uint64_t>("number of the child to begin with")}),
      Control(NodeType::kRandomSequence, "RandomSequence",
              "A Sequence with another order in each activation.",
              {In<std::uint64_t>("seed", "the same seed gives the same orders", "0"),
               Own<std::uint64_t>("number of activations")}),
      Control(NodeType::kRandomSelector, "RandomSelector",
              "A Fallback with another order in each activation.",
              {In<std::uint64_t>("seed", "the same seed gives the same orders", "0"),
               Own<std::uint64_t>("number of activations")}),
  };
}

}  // namespace coppice
