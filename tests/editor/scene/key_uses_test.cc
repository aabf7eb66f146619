#include "editor/scene/key_uses.h"

#include <gtest/gtest.h>

#include "tests/editor/read_forest.h"

namespace coppice::editor {
namespace {

constexpr char kTrees[] = R"(<root BTCPP_format="4">
<BehaviorTree ID="Main"><Sequence>
  <Make out="{goal}"/><Use in="{goal}" n="3"/>
  <SubTree ID="Inner" place="{goal}"/><SubTree ID="Inner" _autoremap="true"/>
</Sequence></BehaviorTree>
<BehaviorTree ID="Inner"><Sequence>
  <Use in="{place}"/><Use in="{goal}"/><Use in="{@goal}"/>
</Sequence></BehaviorTree>
<TreeNodesModel>
  <Action ID="Make"><output_port name="out"/></Action>
  <Action ID="Use"><input_port name="in"/><input_port name="n"/></Action>
</TreeNodesModel></root>)";

class KeyUsesTest : public testing::Test {
 protected:
  KeyUsesTest() {
    forest_ = ReadForest(kTrees);
    models_.AddFrom(*forest_.documents()[0]);
    scene_ = BuildScene(forest_, 0, models_);
    uses_ = FindKeyUses(scene_);
  }
  // The key that the first port of that node names.
  std::uint32_t KeyAt(const char* path) const {
    return uses_.key_of_port[scene_.nodes[scene_.FindPath(path)].first_port];
  }
  Forest forest_;
  NodeModels models_;
  Scene scene_;
  KeyUses uses_;
};

TEST_F(KeyUsesTest, FindsWhoReadsAndWhoWrites) {
  const std::vector<KeyUse>& goal = uses_.uses[KeyAt("1.1")];
  EXPECT_TRUE(goal[0].writes);
  EXPECT_FALSE(goal[0].reads);
  EXPECT_EQ(scene_.nodes[goal[1].node].path, "1.2");
  EXPECT_TRUE(goal[1].reads);
  EXPECT_FALSE(goal[1].writes);
}

TEST_F(KeyUsesTest, FollowsAKeyIntoASubTreeUnderItsOtherName) {
  EXPECT_EQ(KeyAt("1.3.1.1"), KeyAt("1.1"));
  EXPECT_NE(KeyAt("1.3.1.2"), KeyAt("1.1")) << "a key of the SubTree's own";
}

TEST_F(KeyUsesTest, FollowsAutoremapAndKeysOfTheMainTree) {
  EXPECT_EQ(KeyAt("1.4.1.2"), KeyAt("1.1"));
  EXPECT_EQ(KeyAt("1.3.1.3"), KeyAt("1.1"));
}

TEST_F(KeyUsesTest, CountsASubTreeAsNeitherReaderNorWriter) {
  for (const KeyUse& use : uses_.uses[KeyAt("1.1")]) {
    const bool is_subtree = scene_.nodes[use.node].path == "1.3";
    EXPECT_NE(is_subtree, use.reads || use.writes);
  }
}

TEST_F(KeyUsesTest, LeavesLiteralsOut) {
  EXPECT_EQ(uses_.key_of_port[scene_.nodes[scene_.FindPath("1.2")].first_port + 1], kNoKey);
}

}  // namespace
}  // namespace coppice::editor
