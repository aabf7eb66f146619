// Structure: nodes, children, trees. Ports are in ports_test.cc, SubTrees in subtree_test.cc.
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

TEST(Compiler, LaysNodesInPreorder) {
  Diagnostics diagnostics;
  const auto program = CompileText(
      Main("<Sequence><Inverter><AlwaysFailure/></Inverter><AlwaysSuccess/></Sequence>"),
      diagnostics, TestRegistry());
  ASSERT_TRUE(program) << diagnostics.ToString();
  const NodeType types[] = {NodeType::kSequence, NodeType::kInverter, NodeType::kAlwaysFailure,
                            NodeType::kAlwaysSuccess};
  const NodeIndex ends[] = {4, 3, 3, 4};
  const NodeIndex parents[] = {0, 0, 1, 0};
  ASSERT_EQ(program->nodes.size(), 4U);
  for (NodeIndex i = 0; i < 4; ++i) {
    EXPECT_EQ(program->nodes[i].type, types[i]) << i;
    EXPECT_EQ(program->nodes[i].end, ends[i]) << i;
    EXPECT_EQ(program->info[i].parent, parents[i]) << i;
  }
}

TEST(Compiler, ReadsTheGenericForm) {
  EXPECT_EQ(Problems(Main("<Control ID=\"ReactiveSequence\"><Decorator ID=\"Inverter\">"
                          "<Action ID=\"AlwaysFailure\"/></Decorator></Control>")),
            "");
}

TEST(Compiler, GenericFormNeedsAnId) {
  EXPECT_EQ(Problems(Main("<Action/>")), "t.xml:3:1: error: <Action> without ID\n");
}

TEST(Compiler, WarnsOfTheWrongGenericForm) {
  EXPECT_EQ(Problems(Main("<Action ID=\"Sequence\"><AlwaysSuccess/></Action>")),
            "t.xml:3:1: warning: \"Sequence\" is written as <Action> (it is a Control)\n");
}

TEST(Compiler, UnknownNodeGetsTheNearestName) {
  EXPECT_EQ(Problems(Main("  <Sequense><AlwaysSuccess/></Sequense>")),
            "t.xml:3:3: error: unknown node type \"Sequense\" (did you mean \"Sequence\"?)\n");
}

TEST(Compiler, ChecksTheNumberOfChildren) {
  EXPECT_EQ(Problems(Main("<Sequence/>")),
            "t.xml:3:1: error: Sequence has 0 children, expected at least 1\n");
  EXPECT_EQ(Problems(Main("<Inverter><AlwaysSuccess/><AlwaysSuccess/></Inverter>")),
            "t.xml:3:1: error: Inverter has 2 children, expected exactly 1\n");
  EXPECT_EQ(Problems(Main("<AlwaysSuccess><AlwaysSuccess/></AlwaysSuccess>")),
            "t.xml:3:1: error: AlwaysSuccess has 1 children, expected none\n");
}

TEST(Compiler, RefusesScripts) {
  EXPECT_EQ(Problems(Main("<AlwaysSuccess name=\"x\" _skipIf=\"a > 1\"/>")),
            "t.xml:3:25: error: scripts are not supported yet: _skipIf\n");
}

TEST(Compiler, RefusesUnknownUnderscoreAttributes) {
  EXPECT_EQ(Problems(Main("<AlwaysSuccess _skipif=\"a\"/>")),
            "t.xml:3:16: error: unknown attribute \"_skipif\" (did you mean \"_skipIf\"?)\n");
  EXPECT_EQ(Problems(Main("<AlwaysSuccess _description=\"d\" _collapsed=\"true\"/>")), "");
}

TEST(Compiler, ReportsEverythingInOneRun) {
  EXPECT_EQ(Problems(Main("<Sequence>\n<Nope/>\n<Drive gaol=\"1\" total=\"{t}\"/>\n"
                          "<Repeat num_cycles=\"x\"><AlwaysSuccess/></Repeat>\n"
                          "<SubTree ID=\"Gone\"/>\n<Inverter/>\n</Sequence>")),
            "t.xml:4:1: error: unknown node type \"Nope\"\n"
            "t.xml:5:8: error: Drive has no port \"gaol\" (did you mean \"goal\"?)\n"
            "t.xml:5:1: error: Drive needs its port \"goal\" (where to [m])\n"
            "t.xml:6:21: error: \"x\" is not a value for port \"num_cycles\" of Repeat "
            "(expected int)\n"
            "t.xml:7:1: error: no tree \"Gone\"\n"
            "t.xml:8:1: error: Inverter has 0 children, expected exactly 1\n");
}

TEST(Compiler, TheMainTreeMustExist) {
  EXPECT_EQ(Problems("<root BTCPP_format=\"4\" main_tree_to_execute=\"Mian\">\n"
                     "<BehaviorTree ID=\"Main\"><AlwaysSuccess/></BehaviorTree></root>"),
            "t.xml:1:46: error: no tree \"Mian\" (did you mean \"Main\"?)\n");
  EXPECT_EQ(Problems(Main("<AlwaysSuccess/>"), "Other"), "t.xml:1:1: error: no tree \"Other\"\n");
}

TEST(Compiler, AsksWhichTreeIsTheMainOne) {
  EXPECT_EQ(
      Problems("<root BTCPP_format=\"4\"><BehaviorTree ID=\"A\"><AlwaysSuccess/></BehaviorTree>"
               "<BehaviorTree ID=\"B\"><AlwaysSuccess/></BehaviorTree></root>"),
      "t.xml:1:1: error: which tree is the main one? "
      "(give main_tree_to_execute; there are: A, B)\n");
}

TEST(Compiler, ATreeMayNotHaveTheNameOfANode) {
  const std::string problems =
      Problems(Root("<BehaviorTree ID=\"Main\"><AlwaysSuccess/></BehaviorTree>\n"
                    "<BehaviorTree ID=\"Sequence\"><AlwaysSuccess/></BehaviorTree>"));
  EXPECT_EQ(problems, "t.xml:3:1: error: tree \"Sequence\" has the name of a node type\n");
}

TEST(Compiler, TheFallbackStandsForUnknownLeaves) {
  auto registry = std::make_shared<Registry>();
  registry->SetFallback([](const std::string&) { return std::make_unique<Tell>(); });
  Diagnostics diagnostics;
  const auto program = CompileText(Main("<Anything port=\"1\"/>"), diagnostics, registry);
  ASSERT_TRUE(program) << diagnostics.ToString();
  EXPECT_EQ(program->nodes[0].type, NodeType::kLeaf);
  EXPECT_EQ(program->info[0].entry, nullptr);
}

TEST(Compiler, TheFallbackDoesNotStandForUnknownControls) {
  auto registry = std::make_shared<Registry>();
  registry->SetFallback([](const std::string&) { return std::make_unique<Tell>(); });
  Diagnostics diagnostics;
  EXPECT_FALSE(CompileText(Main("<Sequense><AlwaysSuccess/></Sequense>"), diagnostics, registry));
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:3:1: error: \"Sequense\" is not built in, so it must be a leaf without children "
            "(did you mean \"Sequence\"?)\n");
}

TEST(Compiler, CompileFileReportsAMissingFile) {
  Diagnostics diagnostics;
  EXPECT_FALSE(CompileFile("/no/such.xml", TestRegistry(), diagnostics));
  EXPECT_EQ(diagnostics.ToString(), "/no/such.xml: error: cannot read this file\n");
}

}  // namespace
}  // namespace coppice
