#include "bt_core/data/standard_types.h"
#include "bt_core/nodes/built_in_tables.h"
#include "bt_core/script/script.h"

namespace coppice {

using tables::Any;
using tables::In;
using tables::MayIn;
using tables::Own;

namespace {

BuiltIn Action(NodeType type, std::string id, std::string description,
               std::vector<PortDeclaration> ports = {}) {
  return tables::Node(type, NodeCategory::kAction, tables::kNone, std::move(id),
                      std::move(description), std::move(ports));
}

BuiltIn Question(NodeType type, std::string id, std::string description,
                 std::vector<PortDeclaration> ports) {
  return tables::Node(type, NodeCategory::kCondition, tables::kNone, std::move(id),
                      std::move(description), std::move(ports));
}

}  // namespace

std::vector<BuiltIn> BuiltInLeaves() {
  return {
      Action(NodeType::kAlwaysSuccess, "AlwaysSuccess", "Succeeds."),
      Action(NodeType::kAlwaysFailure, "AlwaysFailure", "Fails."),
      Action(NodeType::kSleep, "Sleep", "Waits, then succeeds.",
             {In<unsigned>("msec", "how long [ms]")}),
      Action(NodeType::kScript, "Script", "Runs a script.",
             {In<ScriptCode>("code", "what to run")}),
      Question(NodeType::kScriptCondition, "ScriptCondition",
               "Succeeds if the value of a script is true.",
               {In<ScriptCode>("code", "the question")}),
      Action(NodeType::kSetBlackboard, "SetBlackboard", "Copies a value to a key.",
             {Any(PortDirection::kInput, "value", "a literal or a key"),
              Any(PortDirection::kOutput, "output_key", "the key to write")}),
      Action(NodeType::kUnsetBlackboard, "UnsetBlackboard", "Empties a key.",
             {Any(PortDirection::kOutput, "key", "the key")}),
      Action(
          NodeType::kWasEntryUpdated, "WasEntryUpdated",
          "Succeeds if a key was written since it was last asked.",
          {Any(PortDirection::kInput, "entry", "the key"), Own<std::uint64_t>("writes seen + 1")}),
      Question(NodeType::kHysteresis, "Hysteresis",
               "Succeeds from the time a value is high until it is low.",
               {In<double>("value", "what is measured"), In<double>("low", "low is this or less"),
                In<double>("high", "high is this or more"), Own<bool>("is it high?")}),
      Action(NodeType::kTestNode, "TestNode", "Stands in for a leaf in a test.",
             {In<Status>("return_status", "its result", "SUCCESS"),
              In<unsigned>("async_delay", "how long it runs before [ms]", "0"),
              MayIn<ScriptCode>("success_script", "runs before SUCCESS"),
              MayIn<ScriptCode>("failure_script", "runs before FAILURE"),
              MayIn<ScriptCode>("post_script", "runs last")}),
  };
}

}  // namespace coppice
