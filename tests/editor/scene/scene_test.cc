#include "editor/scene/scene.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"
#include "tests/editor/read_forest.h"

namespace coppice::editor {
namespace {

class SceneTest : public testing::Test {
 protected:
  const Scene& Build(const std::string& xml, std::size_t limit = 1000) {
    forest_ = ReadForest(xml);
    for (const Document* document : forest_.documents()) models_.AddFrom(*document);
    scene_ = BuildScene(forest_, forest_.main_tree(), models_, limit);
    return scene_;
  }
  Forest forest_;
  NodeModels models_;
  Scene scene_;
};

TEST_F(SceneTest, WritesSubTreesOutInPlaceAndNumbersThePaths) {
  const Scene& scene = Build(kSmallFile);
  std::string paths;
  for (const SceneNode& node : scene.nodes) paths += node.path + " ";
  EXPECT_EQ(paths, "1 1.1 1.1.1 1.1.1.1 1.1.2 1.2 1.2.1 1.2.1.1 1.3 ");
  EXPECT_EQ(scene.nodes[0].end, 9U);
  EXPECT_EQ(scene.nodes[5].end, 8U);
  EXPECT_EQ(scene.nodes[5].shape, Shape::kSubTree);
  EXPECT_EQ(scene.nodes[5].id, "Walk");
  EXPECT_EQ(scene.nodes[5].name, "walk");
  EXPECT_EQ(scene.nodes[7].scope, 1U);
  EXPECT_EQ(scene.scopes[1], "walk");
}

TEST_F(SceneTest, WhatLiesInADisabledNodeIsDisabledToo) {
  const Scene& scene = Build(R"(<root BTCPP_format="4"><BehaviorTree ID="T"><Sequence>
      <Fallback _skipIf="true"><SubTree ID="U"/></Fallback><AlwaysSuccess/></Sequence>
      </BehaviorTree><BehaviorTree ID="U"><AlwaysSuccess/></BehaviorTree></root>)");
  std::string disabled;
  for (const SceneNode& node : scene.nodes) disabled += node.disabled ? node.path + " " : "";
  EXPECT_EQ(disabled, "1.1 1.1.1 1.1.1.1 ");
}

TEST_F(SceneTest, GivesEveryNodeItsShape) {
  const Scene& scene = Build(kSmallFile);
  EXPECT_EQ(scene.nodes[0].shape, Shape::kControl);
  EXPECT_EQ(scene.nodes[2].shape, Shape::kDecorator);
  EXPECT_EQ(scene.nodes[3].shape, Shape::kCondition);
  EXPECT_EQ(scene.nodes[4].shape, Shape::kAction);
  EXPECT_EQ(scene.nodes[7].shape, Shape::kUnknown);
}

TEST_F(SceneTest, OrdersPortsAsDeclared) {
  const Scene& scene = Build(kSmallFile);
  const SceneNode& lamp = scene.nodes[4];
  ASSERT_EQ(lamp.port_count, 2U);
  EXPECT_EQ(scene.ports[lamp.first_port].name, "level");
  EXPECT_FALSE(scene.ports[lamp.first_port].key.empty());
  EXPECT_EQ(scene.ports[lamp.first_port + 1].name, "lamp");
}

TEST_F(SceneTest, ReadsTheExplicitForm) {
  const Scene& scene =
      Build(R"(<root><BehaviorTree ID="T"><Control ID="Sequence"><Condition ID="Mine"/>)"
            "</Control></BehaviorTree></root>");
  EXPECT_EQ(scene.nodes[0].id, "Sequence");
  EXPECT_EQ(scene.nodes[1].id, "Mine");
  EXPECT_EQ(scene.nodes[1].shape, Shape::kCondition);
}

TEST_F(SceneTest, StopsAtATreeInsideItself) {
  const Scene& scene =
      Build(R"(<root><BehaviorTree ID="A"><Sequence><SubTree ID="B"/></Sequence></BehaviorTree>)"
            R"(<BehaviorTree ID="B"><Sequence><SubTree ID="A"/></Sequence></BehaviorTree></root>)");
  ASSERT_EQ(scene.nodes.size(), 4U);
  EXPECT_TRUE(scene.nodes[3].recursive);
}

TEST_F(SceneTest, StopsGrowingAtTheLimit) {
  // Each tree uses the next one ten times: 10^6 nodes if written out.
  std::string xml = "<root>";
  for (int i = 0; i < 6; ++i) {
    xml += "<BehaviorTree ID=\"T" + std::to_string(i) + "\"><Sequence>";
    for (int k = 0; k < 10; ++k) xml += "<SubTree ID=\"T" + std::to_string(i + 1) + "\"/>";
    xml += "</Sequence></BehaviorTree>";
  }
  const Scene& scene = Build(xml + "</root>", 1000);
  EXPECT_GT(scene.nodes.size(), 500U);
  EXPECT_LT(scene.nodes.size(), 1200U);
}

// What each instance takes along: the comment, and the path of the one around it.
TEST_F(SceneTest, StopsGrowingWhenItsTextsTakeTooMuch) {
  std::string calls;
  for (int i = 0; i < 900; ++i) calls += "<SubTree ID=\"B\"/>";
  const Scene& scene =
      Build("<root><BehaviorTree ID=\"M\"><SubTree ID=\"A\" name=\"" + std::string(100'000, 'n') +
                "\"/></BehaviorTree>" + "<BehaviorTree ID=\"A\"><Sequence>" + calls +
                "</Sequence></BehaviorTree><BehaviorTree ID=\"B\"><!-- " +
                std::string(100'000, 'c') + " --><AlwaysSuccess/></BehaviorTree></root>",
            10'000);
  std::size_t bytes = 0;
  for (const std::string& scope : scene.scopes) bytes += scope.size();
  for (const SceneNode& node : scene.nodes) bytes += node.path.size() + node.note.size();
  EXPECT_LT(bytes, std::size_t{26} << 20);
  EXPECT_GT(bytes, std::size_t{20} << 20);
}

TEST_F(SceneTest, IsEmptyWithoutATree) {
  EXPECT_TRUE(Build("<root/>").nodes.empty());
  EXPECT_TRUE(Build(R"(<root><BehaviorTree ID="E"/></root>)").nodes.empty());
}

}  // namespace
}  // namespace coppice::editor
