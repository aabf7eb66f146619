// Structure: nodes and children.
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
  const NodeIndex ends[] = {NodeIndex{4}, NodeIndex{3}, NodeIndex{3}, NodeIndex{4}};
  const NodeIndex parents[] = {kRootNode, kRootNode, NodeIndex{1}, kRootNode};
  ASSERT_EQ(program->nodes.size(), 4U);
  for (NodeIndex i{0}; i < 4; ++i) {
    EXPECT_EQ(program->nodes[i].type, types[i]) << i;
    EXPECT_EQ(program->nodes[i].end, ends[i]) << i;
    EXPECT_EQ(program->info[i].parent, parents[i]) << i;
  }
}

TEST(Compiler, ChecksTheNumberOfChildren) {
  EXPECT_EQ(Problems(Main("<Sequence/>")),
            "t.xml:3:1: error: Sequence has 0 children, expected at least 1\n");
  EXPECT_EQ(Problems(Main("<Inverter><AlwaysSuccess/><AlwaysSuccess/></Inverter>")),
            "t.xml:3:1: error: Inverter has 2 children, expected exactly 1\n");
  EXPECT_EQ(Problems(Main("<AlwaysSuccess><AlwaysSuccess/></AlwaysSuccess>")),
            "t.xml:3:1: error: AlwaysSuccess has 1 child, expected none\n");
}

TEST(Compiler, ReportsEverythingInOneRun) {
  EXPECT_EQ(Problems(Main("<Sequence>\n<Nope/>\n<Drive gaol=\"1\" total=\"{t}\"/>\n"
                          "<Repeat num_cycles=\"x\"><AlwaysSuccess/></Repeat>\n"
                          "<SubTree ID=\"Gone\"/>\n<Inverter/>\n</Sequence>")),
            "t.xml:4:1: error: unknown node type \"Nope\"\n"
            "t.xml:5:8: error: Drive has no port \"gaol\" (did you mean \"goal\"?)\n"
            "t.xml:5:1: error: Drive needs its port \"goal\" (where to [m])\n"
            R"(t.xml:6:21: error: "x" is not a value for port "num_cycles" of Repeat )"
            "(expected int)\n"
            "t.xml:7:1: error: no tree \"Gone\"\n"
            "t.xml:8:1: error: Inverter has 0 children, expected exactly 1\n");
}

}  // namespace
}  // namespace coppice
