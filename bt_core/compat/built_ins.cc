#include "bt_core/compat/built_ins.h"

#include <map>
#include <utility>

#include "bt_core/script/script.h"

namespace BT::internal {
namespace {

using Make = std::unique_ptr<TreeNode> (*)(const std::string&, const NodeConfig&);

template <class T>
std::unique_ptr<TreeNode> MakeOne(const std::string& name, const NodeConfig& config) {
  return std::make_unique<T>(name, config);
}

template <class... Classes>
std::map<std::string, Make> Table() {
  return {{Classes::kBuiltInId, &MakeOne<Classes>}...};
}

const std::map<std::string, Make>& Classes() {
  static const auto table =
      Table<SequenceNode, AsyncSequence, FallbackNode, AsyncFallback, ReactiveSequence,
            ReactiveFallback, ParallelNode, ParallelAllNode, IfThenElseNode, WhileDoElseNode,
            SwitchNode<2>, SwitchNode<3>, SwitchNode<4>, SwitchNode<5>, SwitchNode<6>,
            SequenceWithMemory, TryCatchNode, InverterNode, ForceSuccessNode, ForceFailureNode,
            RetryNode, RepeatNode, KeepRunningUntilFailureNode, TimeoutNode, DelayNode, RunOnceNode,
            PreconditionNode, SubTreeNode, EntryUpdatedDecorator, AlwaysSuccessNode,
            AlwaysFailureNode, ScriptNode, ScriptCondition, SetBlackboardNode, UnsetBlackboardNode,
            SleepNode, EntryUpdatedAction>();
  return table;
}

NodeType TypeOf(coppice::NodeCategory category) {
  switch (category) {
    case coppice::NodeCategory::kAction:
      return NodeType::ACTION;
    case coppice::NodeCategory::kCondition:
      return NodeType::CONDITION;
    case coppice::NodeCategory::kControl:
      return NodeType::CONTROL;
    case coppice::NodeCategory::kDecorator:
      return NodeType::DECORATOR;
    case coppice::NodeCategory::kSubTree:
      break;
  }
  return NodeType::SUBTREE;
}

PortDirection DirectionOf(coppice::PortDirection direction) {
  if (direction == coppice::PortDirection::kInput) return PortDirection::INPUT;
  return direction == coppice::PortDirection::kOutput ? PortDirection::OUTPUT
                                                      : PortDirection::INOUT;
}

}  // namespace

std::unique_ptr<TreeNode> MakeBuiltIn(const coppice::Registry::Entry& entry,
                                      const std::string& name, const NodeConfig& config) {
  const auto found = Classes().find(entry.manifest.id);
  if (found != Classes().end()) return found->second(name, config);
  switch (TypeOf(entry.manifest.category)) {  // Coppice's own
    case NodeType::CONTROL:
      return std::make_unique<BuiltIn<ControlNode>>(name, config);
    case NodeType::DECORATOR:
      return std::make_unique<BuiltIn<DecoratorNode>>(name, config);
    case NodeType::CONDITION:
      return std::make_unique<BuiltIn<ConditionNode>>(name, config);
    default:
      return std::make_unique<BuiltInAction>(name, config);
  }
}

TypeInfo InfoOf(const coppice::Type* type) {
  if (!type) return TypeInfo();
  if (type == &coppice::TypeOf<coppice::ScriptCode>()) return TypeInfo::Create<std::string>();
  return TypeInfo(*type->info, [type](StringView text) {
    Any value;
    if (!value.value().Parse(*type, text)) {
      throw RuntimeError("\"", text, "\" is no ", type->name);
    }
    return value;
  });
}

TreeNodeManifest ManifestOf(const coppice::Manifest& manifest) {
  TreeNodeManifest out{TypeOf(manifest.category), manifest.id, {}, {}};
  for (const coppice::PortDeclaration& port : manifest.ports) {
    const TypeInfo info = InfoOf(port.type);
    PortInfo described(DirectionOf(port.direction), info.type(), info.converter());
    described.setDescription(port.description);
    if (port.default_text) described.setDefaultValue(*port.default_text);
    out.ports.emplace(port.name, std::move(described));
  }
  return out;
}

}  // namespace BT::internal
