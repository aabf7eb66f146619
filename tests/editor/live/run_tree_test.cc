#include "editor/live/run_tree.h"

#include <gtest/gtest.h>

#include "bt_core/live/groot2/client_robot_tree.h"
#include "tests/editor/driver.h"
#include "tests/editor/timeline/executed_run.h"

namespace coppice::editor {
namespace {

TEST(RunTreeTest, GivesTheNodesOfTheSceneTheirNumbersInTheRun) {
  ExecutedTree robot(R"(<BehaviorTree ID="Main"><Sequence><Is/><SubTree ID="Sub"/>
    <SubTree ID="Sub"/></Sequence></BehaviorTree>
    <BehaviorTree ID="Sub"><Fallback><Do/><Is/></Fallback></BehaviorTree>)");
  const Program& program = *robot.executor.shared_program();
  const RunTree tree(std::make_shared<const TreeDescription>(DescribeTree(program, {})),
                     NodeModels());
  Scene scene = BuildScene(tree.forest(), tree.forest().main_tree(), tree.models());
  NumberNodes(*tree.description(), scene);
  ASSERT_EQ(scene.nodes.size(), program.nodes.size());
  for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
    EXPECT_EQ(scene.nodes[i].run_node, i);
    EXPECT_EQ(scene.of_run_node[i], i);
  }
  ASSERT_NE(tree.models().Find("Do"), nullptr) << "the run brings its models";
  EXPECT_EQ(tree.models().Find("Do")->source, "the running program") << "no file holds them";
  EXPECT_NE(tree.recorded().program, nullptr);
}

TEST(RunTreeTest, KnowsTheTreeOfARobotWithTheGroot2Protocol) {
  Diagnostics diagnostics;
  const RobotTree robot = ReadRobotTree(kLiveTree, "robot:1", diagnostics);
  const RunTree tree(std::make_shared<const TreeDescription>(robot.description), NodeModels());
  Scene scene = BuildScene(tree.forest(), tree.forest().main_tree(), tree.models());
  NumberNodes(*tree.description(), scene);
  const std::uint32_t step = scene.FindPath("1.2.1.1");
  ASSERT_NE(step, kNoSceneNode);
  EXPECT_EQ(scene.nodes[step].run_node, robot.Find(5));
  EXPECT_FALSE(tree.problems().has_errors()) << tree.problems().ToString();
}

}  // namespace
}  // namespace coppice::editor
