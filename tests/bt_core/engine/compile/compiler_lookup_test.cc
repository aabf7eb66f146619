// What an element is: forms, unknown types, the fallback.
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

std::string Problems(const std::string& text, const std::string& tree = {}) {
  Diagnostics diagnostics;
  const auto program = CompileText(text, diagnostics, TestRegistry(), tree);
  EXPECT_EQ(program == nullptr, diagnostics.has_errors());
  return diagnostics.ToString();
}

TEST(NodeLookup, ReadsTheGenericForm) {
  EXPECT_EQ(Problems(Main(R"(<Control ID="ReactiveSequence"><Decorator ID="Inverter">)"
                          R"(<Action ID="AlwaysFailure"/></Decorator></Control>)")),
            "");
}

TEST(NodeLookup, GenericFormNeedsAnId) {
  EXPECT_EQ(Problems(Main("<Action/>")), "t.xml:3:1: error: <Action> without ID\n");
}

TEST(NodeLookup, WarnsOfTheWrongGenericForm) {
  EXPECT_EQ(Problems(Main(R"(<Action ID="Sequence"><AlwaysSuccess/></Action>)")),
            "t.xml:3:1: warning: \"Sequence\" is written as <Action> (it is a Control)\n");
}

TEST(NodeLookup, UnknownNodeGetsTheNearestName) {
  EXPECT_EQ(Problems(Main("  <Sequense><AlwaysSuccess/></Sequense>")),
            "t.xml:3:3: error: unknown node type \"Sequense\" (did you mean \"Sequence\"?)\n");
}

TEST(NodeLookup, ATreeIsNotANodeType) {
  EXPECT_EQ(Problems(Root("<BehaviorTree ID=\"Main\"><Other/></BehaviorTree>\n"
                          R"(<BehaviorTree ID="Other"><AlwaysSuccess/></BehaviorTree>)")),
            R"(t.xml:2:25: error: unknown node type "Other" (a tree is used as <SubTree )"
            "ID=\"Other\"/>)\n");
}

TEST(NodeLookup, TheFallbackStandsForUnknownLeaves) {
  auto registry = std::make_shared<Registry>();
  registry->SetFallback([](const std::string&) { return std::make_unique<Tell>(); });
  Diagnostics diagnostics;
  const auto program = CompileText(Main(R"(<Anything port="1"/>)"), diagnostics, registry);
  ASSERT_TRUE(program) << diagnostics.ToString();
  EXPECT_EQ(program->nodes[0].type, NodeType::kLeaf);
  EXPECT_EQ(program->info[0].entry, nullptr);
}

TEST(NodeLookup, TheFallbackDoesNotStandForUnknownControls) {
  auto registry = std::make_shared<Registry>();
  registry->SetFallback([](const std::string&) { return std::make_unique<Tell>(); });
  Diagnostics diagnostics;
  EXPECT_FALSE(CompileText(Main("<Sequense><AlwaysSuccess/></Sequense>"), diagnostics, registry));
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:3:1: error: \"Sequense\" is not built in, so it must be a leaf without children "
            "(did you mean \"Sequence\"?)\n");
}

TEST(NodeLookup, ACompactElementHasNoId) {
  EXPECT_EQ(Problems(Main(R"(<Fallback ID="Look"><AlwaysSuccess/></Fallback>)")),
            "t.xml:3:11: error: <Fallback> has its type as tag, no ID (name=\"Look\" names the "
            "node)\n");
}

TEST(NodeLookup, WhatBelongsToAFileCannotStandInATree) {
  EXPECT_EQ(Problems(Main("<Sequence><AlwaysSuccess/>\n<include path=\"x\"/>\n<TreeNodesModel/>\n"
                          "<root/></Sequence>")),
            "t.xml:4:1: error: <include> cannot stand inside a tree\n"
            "t.xml:5:1: error: <TreeNodesModel> cannot stand inside a tree\n"
            "t.xml:6:1: error: <root> cannot stand inside a tree\n");
}

TEST(NodeLookup, ANodeOfFormat3IsToldItsNewName) {
  EXPECT_EQ(Problems(Main("<SequenceStar><AlwaysSuccess/></SequenceStar>")),
            "t.xml:3:1: error: unknown node type \"SequenceStar\" (in format 4 it is "
            "SequenceWithMemory)\n");
}

}  // namespace
}  // namespace coppice
