#include "bt_core/live/groot2/client_robot_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bt_core/engine/events/event_words.h"
#include "bt_core/live/groot2/full_tree.h"
#include "tests/bt_core/live/watched_tree.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

RobotTree Read(const std::string& xml, Diagnostics& diagnostics) {
  return ReadRobotTree(xml, "robot", diagnostics);
}

TEST(ClientRobotTree, IsTheTreeThatTheRobotRuns) {
  const auto program = WatchedProgram();
  Diagnostics diagnostics;
  const RobotTree tree = Read(*WriteFullTree(*program), diagnostics);
  ASSERT_EQ(diagnostics.ToString(), "");
  ASSERT_EQ(tree.description.nodes.size(), program->nodes.size());
  for (NodeIndex i{0}; i < program->nodes.size(); ++i) {
    const DescribedNode& node = tree.description.nodes[i];
    EXPECT_EQ(node.path, program->Path(i));
    EXPECT_EQ(node.id, program->Id(i));
    EXPECT_EQ(node.parent, program->info[i].parent);
    EXPECT_EQ(node.runs_one_child, RunsOneChild(program->nodes[i].type));
    EXPECT_EQ(tree.Find(tree.uids[i]), i);
  }
  EXPECT_EQ(tree.description.main_tree, "Main");
  EXPECT_THAT(tree.boards, ElementsAre("Main", "inner"));
  EXPECT_THAT(tree.description.models, HasSubstr(R"(<Action ID="Fill")"));
  EXPECT_EQ(tree.Find(999), kNoNode);
}

// As BehaviorTree.CPP 4 writes it.
TEST(ClientRobotTree, TakesWhatOthersWrite) {
  Diagnostics diagnostics;
  const RobotTree tree = Read(R"(<root BTCPP_format="4">
    <BehaviorTree ID="MainTree" _fullpath="">
      <Sequence name="Sequence" _uid="1">
        <SubTree ID="Door" _fullpath="Door::2" _uid="2"/>
        <SubTree ID="Door" _fullpath="again" _uid="4"/>
      </Sequence>
    </BehaviorTree>
    <BehaviorTree ID="Door" _fullpath="Door::2"><Open name="Open" _uid="3"/></BehaviorTree>
    <BehaviorTree ID="Door" _fullpath="again"><Open name="try" _uid="5"/></BehaviorTree>
    <TreeNodesModel><Condition ID="Open"/></TreeNodesModel></root>)",
                              diagnostics);
  ASSERT_EQ(diagnostics.ToString(), "");
  ASSERT_EQ(tree.description.nodes.size(), 5u);
  EXPECT_THAT(tree.uids, ElementsAre(1, 2, 3, 4, 5));
  EXPECT_EQ(tree.description.nodes[0].path, "Sequence::1");
  EXPECT_EQ(tree.description.nodes[1].path, "Door::2");
  EXPECT_EQ(tree.description.nodes[2].path, "Door::2/Open::3");
  EXPECT_EQ(tree.description.nodes[4].path, "again/try");
  EXPECT_EQ(tree.description.nodes[4].category, NodeCategory::kCondition);
  EXPECT_EQ(tree.description.nodes[4].parent, 3u);
}

TEST(ClientRobotTree, RefusesNonsense) {
  for (const std::string& xml :
       {std::string("<root"), std::string("<root/>"),
        std::string(R"(<root><BehaviorTree ID="A"/></root>)"),
        std::string(R"(<root><BehaviorTree ID="A"><X/></BehaviorTree></root>)"),
        std::string(R"(<root><BehaviorTree ID="A"><X _uid="70000"/></BehaviorTree></root>)"),
        std::string(
            R"(<root><BehaviorTree ID="A"><X _uid="1"/><X _uid="1"/></BehaviorTree></root>)"),
        std::string(R"(<root><BehaviorTree ID="A"><SubTree _uid="1" _fullpath="b"/></BehaviorTree>)"
                    "</root>"),
        std::string(R"(<root><BehaviorTree ID="A"><SubTree _uid="1" _fullpath="b"/></BehaviorTree>)"
                    R"(<BehaviorTree ID="B" _fullpath="b"><SubTree _uid="2" _fullpath="b"/>)"
                    "</BehaviorTree></root>")}) {
    Diagnostics diagnostics;
    EXPECT_TRUE(Read(xml, diagnostics).uids.empty()) << xml;
    EXPECT_TRUE(diagnostics.has_errors()) << xml;
  }
}

// A robot that is none could have each node take the whole of a long path.
TEST(ClientRobotTree, RefusesPathsThatMultiply) {
  const std::string path(100'000, 'p');
  std::string nodes;
  for (int i = 3; i < 1000; ++i) nodes += "<Open _uid=\"" + std::to_string(i) + "\"/>";
  Diagnostics diagnostics;
  const RobotTree tree = Read(
      "<root BTCPP_format=\"4\"><BehaviorTree ID=\"M\" _fullpath=\"\">"
      "<SubTree ID=\"T\" _uid=\"1\" _fullpath=\"" +
          path + "\"/></BehaviorTree><BehaviorTree ID=\"T\" _fullpath=\"" + path +
          "\"><Sequence _uid=\"2\">" + nodes + "</Sequence></BehaviorTree></root>",
      diagnostics);
  EXPECT_TRUE(tree.uids.empty());
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("the paths of nodes are too long"));
}

}  // namespace
}  // namespace coppice
