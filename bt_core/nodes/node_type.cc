#include "bt_core/nodes/node_type.h"

#include <string>
#include <utility>

namespace coppice {
namespace {

constexpr ChildCount kMany{1, UINT32_MAX};
constexpr ChildCount kOne{1, 1};
constexpr ChildCount kNone{0, 0};

template <class T>
PortDeclaration In(std::string name, std::string description,
                   std::optional<std::string> default_text = std::nullopt) {
  const bool required = !default_text.has_value();
  return {std::move(name), PortDirection::kInput,  &TypeOf<T>(), std::move(description),
          required,        std::move(default_text)};
}

BuiltIn Control(NodeType type, std::string id, std::string description,
                std::vector<PortDeclaration> ports = {}) {
  return {type,
          kMany,
          {std::move(id), NodeCategory::kControl, std::move(description), std::move(ports)}};
}

BuiltIn Decorator(NodeType type, std::string id, std::string description,
                  std::vector<PortDeclaration> ports = {}) {
  return {type,
          kOne,
          {std::move(id), NodeCategory::kDecorator, std::move(description), std::move(ports)}};
}

BuiltIn Constant(NodeType type, std::string id, std::string description) {
  return {type, kNone, {std::move(id), NodeCategory::kAction, std::move(description), {}}};
}

}  // namespace

const std::vector<BuiltIn>& BuiltIns() {
  static const std::vector<BuiltIn> all = {
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
      Control(NodeType::kParallel, "Parallel",
              "Ticks all unfinished children in every tick; ends when enough succeeded or failed.",
              {In<int>("success_count", "successes that make it succeed; -1 = all children", "-1"),
               In<int>("failure_count", "failures that make it fail; -1 = all children", "1")}),
      Decorator(NodeType::kInverter, "Inverter", "Turns success into failure and back."),
      Decorator(NodeType::kForceSuccess, "ForceSuccess", "Succeeds whatever its child does."),
      Decorator(NodeType::kForceFailure, "ForceFailure", "Fails whatever its child does."),
      Decorator(NodeType::kRepeat, "Repeat",
                "Runs its child again and again while it succeeds. Yields after every cycle.",
                {In<int>("num_cycles", "how often; -1 = for ever")}),
      Decorator(NodeType::kRetryUntilSuccessful, "RetryUntilSuccessful",
                "Runs its child again while it fails. Yields after every attempt.",
                {In<int>("num_attempts", "how often; -1 = for ever")}),
      Decorator(NodeType::kTimeout, "Timeout", "Halts its child and fails when it takes too long.",
                {In<unsigned>("msec", "limit [ms]; 0 = none")}),
      Decorator(NodeType::kDelay, "Delay", "Waits, then ticks its child.",
                {In<unsigned>("delay_msec", "how long to wait [ms]")}),
      {NodeType::kSubTree,
       kNone,
       {"SubTree",
        NodeCategory::kSubTree,
        "Runs another tree with a blackboard scope of its own.",
        {}}},
      Constant(NodeType::kAlwaysSuccess, "AlwaysSuccess", "Succeeds."),
      Constant(NodeType::kAlwaysFailure, "AlwaysFailure", "Fails."),
  };
  return all;
}

}  // namespace coppice
