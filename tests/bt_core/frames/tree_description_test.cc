#include "bt_core/frames/tree_description.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bt_core/engine/program.h"
#include "tests/bt_core/frames/scripted_tree.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST(TreeDescription, SaysWhatTheProgramIs) {
  LeafScript script;
  const auto program = ScriptedProgram(script);
  const TreeDescription tree = DescribeTree(*program, {});
  EXPECT_EQ(tree.main_tree, "Main");
  ASSERT_THAT(tree.documents, SizeIs(1));
  EXPECT_EQ(tree.documents[0].file, "recorded.xml");
  EXPECT_EQ(tree.documents[0].text, program->texts[0].text());
  EXPECT_THAT(tree.models, HasSubstr(R"(<Action ID="Scripted">)"));
  ASSERT_THAT(tree.nodes, SizeIs(5));
  EXPECT_EQ(tree.nodes[0].id, "Sequence");
  EXPECT_EQ(tree.nodes[0].category, NodeCategory::kControl);
  EXPECT_TRUE(tree.nodes[0].runs_one_child);
  EXPECT_EQ(tree.nodes[3].path, "second");
  EXPECT_EQ(tree.nodes[3].parent, 2u);
  EXPECT_EQ(tree.nodes[3].category, NodeCategory::kAction);
  EXPECT_FALSE(tree.nodes[3].runs_one_child);
}

TEST(TreeDescription, SaysWhichPortsAreBoundToWhichSlots) {
  LeafScript script;
  const TreeDescription tree = DescribeTree(*ScriptedProgram(script), {});
  ASSERT_THAT(tree.nodes[1].ports, SizeIs(2));
  EXPECT_EQ(tree.nodes[1].ports[0].name, "number");
  const DescribedSlot& slot = tree.slots.at(tree.nodes[1].ports[0].slot);
  EXPECT_EQ(slot.scope, "Main");
  EXPECT_EQ(slot.name, "number");
  EXPECT_EQ(slot.type, "int");
  EXPECT_TRUE(slot.has_key);
}

TEST(TreeDescription, NamesALiteralAfterItsPort) {
  LeafScript script;
  const TreeDescription tree =
      DescribeTree(*CompileScripted(script, R"(<root BTCPP_format="4"><BehaviorTree ID="T">
        <Delay name="wait" delay_msec="5"><AlwaysSuccess/></Delay></BehaviorTree></root>)"),
                   {});
  ASSERT_FALSE(tree.nodes[0].ports.empty());
  const DescribedSlot& slot = tree.slots.at(tree.nodes[0].ports[0].slot);
  EXPECT_EQ(slot.name, "wait.delay_msec");
  EXPECT_FALSE(slot.has_key);
}

TEST(TreeDescription, HasTheShapeOfTheProgram) {
  LeafScript script;
  const auto program = ScriptedProgram(script);
  const TreeShape expected = ShapeOf(*program);
  const TreeShape shape = ShapeOf(DescribeTree(*program, {}));
  ASSERT_EQ(shape.size(), expected.size());
  for (std::size_t i = 0; i < shape.size(); ++i) {
    EXPECT_EQ(shape[i].parent, expected[i].parent);
    EXPECT_EQ(shape[i].end, expected[i].end);
    EXPECT_EQ(shape[i].runs_one_child, expected[i].runs_one_child);
  }
}

TEST(RunInfo, KnowsItsClockAndWhenItBegan) {
  SimulatedClock simulated(Duration(5));
  const RunInfo info = BeginRun(simulated);
  EXPECT_EQ(info.clock, "simulated");
  EXPECT_EQ(info.start, Time(Duration(5)));
  EXPECT_GT(info.wall_start, WallTime(std::chrono::hours(24 * 365 * 50)));
  EXPECT_EQ(BeginRun(WallClock()).clock, "wall");
}

TEST(RunId, IsAnotherForEachRun) {
  EXPECT_NE(MakeRunId(), MakeRunId());
  EXPECT_EQ(ToString(RunId{1, 0xab}), "01ab0000000000000000000000000000");
}

}  // namespace
}  // namespace coppice
