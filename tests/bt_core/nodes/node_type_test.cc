#include "bt_core/nodes/node_type.h"

#include <gtest/gtest.h>

#include <set>

namespace coppice {
namespace {

TEST(BuiltIns, AreAllTypesThatAreNotUserCode) {
  std::set<NodeType> types;
  for (const BuiltIn& node : BuiltIns()) types.insert(node.type);
  EXPECT_EQ(types.size(), static_cast<std::size_t>(NodeType::kLeaf));
  EXPECT_EQ(types.upper_bound(NodeType::kLeaf), types.end());
}

TEST(BuiltIns, HaveDistinctIdsAndDescriptions) {
  std::set<std::string> ids;
  for (const BuiltIn& node : BuiltIns()) {
    EXPECT_TRUE(ids.insert(node.manifest.id).second) << node.manifest.id;
    EXPECT_FALSE(node.manifest.description.empty()) << node.manifest.id;
    for (const PortDeclaration& port : node.manifest.ports) {
      EXPECT_FALSE(port.description.empty()) << node.manifest.id << "." << port.name;
    }
  }
}

TEST(BuiltIns, HaveChildrenAccordingToTheirCategory) {
  for (const BuiltIn& node : BuiltIns()) {
    const NodeCategory category = node.manifest.category;
    const bool control = category == NodeCategory::kControl;
    const bool decorator = category == NodeCategory::kDecorator;
    EXPECT_EQ(node.children.min > 0, control || decorator) << node.manifest.id;
    EXPECT_EQ(node.children.max > 1, control) << node.manifest.id;
    EXPECT_LE(node.children.min, node.children.max) << node.manifest.id;
    if (decorator) {
      EXPECT_EQ(node.children.max, 1U) << node.manifest.id;
    }
  }
}

TEST(BuiltIns, DefaultsAreValuesOfTheirPorts) {
  for (const BuiltIn& node : BuiltIns()) {
    for (const PortDeclaration& port : node.manifest.ports) {
      if (!port.default_text) continue;
      EXPECT_FALSE(port.required) << port.name;
      Value value;
      EXPECT_TRUE(value.Parse(*port.type, *port.default_text)) << port.name;
    }
  }
}

TEST(BuiltIns, HaveTheIdsOfThePeer) {
  std::set<std::string> ids;
  for (const BuiltIn& node : BuiltIns()) ids.insert(node.manifest.id);
  for (const char* id : {"AlwaysFailure",
                         "AlwaysSuccess",
                         "AsyncFallback",
                         "AsyncSequence",
                         "Delay",
                         "Fallback",
                         "ForceFailure",
                         "ForceSuccess",
                         "IfThenElse",
                         "Inverter",
                         "KeepRunningUntilFailure",
                         "LoopBool",
                         "LoopDouble",
                         "LoopInt",
                         "LoopString",
                         "Parallel",
                         "ParallelAll",
                         "Precondition",
                         "ReactiveFallback",
                         "ReactiveSequence",
                         "Repeat",
                         "RetryUntilSuccessful",
                         "RunOnce",
                         "Script",
                         "ScriptCondition",
                         "Sequence",
                         "SequenceWithMemory",
                         "SetBlackboard",
                         "SkipUnlessUpdated",
                         "Sleep",
                         "SubTree",
                         "Switch2",
                         "Switch3",
                         "Switch4",
                         "Switch5",
                         "Switch6",
                         "Timeout",
                         "TryCatch",
                         "UnsetBlackboard",
                         "WaitValueUpdate",
                         "WasEntryUpdated",
                         "WhileDoElse"}) {
    EXPECT_EQ(ids.count(id), 1U) << id;
  }
}

}  // namespace
}  // namespace coppice
