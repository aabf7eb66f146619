#include "editor/scene/key_uses.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/bt_core/engine/fixture.h"
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

// How many keys there are: what the engine compiles, beside what the editor shows.
class EngineAndEditorTest : public testing::Test {
 protected:
  static std::size_t KeysOfEngine(const std::string& xml) {
    const coppice::Stage stage(xml);
    const auto& slots = stage.program->layout.slots;
    return static_cast<std::size_t>(std::count_if(
        slots.begin(), slots.end(), [](const auto& slot) { return !slot.key.empty(); }));
  }
  static std::size_t KeysOfEditor(const std::string& xml) {
    const Forest forest = ReadForest(xml);
    NodeModels models;
    models.AddFrom(*forest.documents()[0]);
    return FindKeyUses(BuildScene(forest, 0, models)).uses.size();
  }
  // Main uses the key t and has a SubTree with these attributes, in which a port is given `text`.
  static std::string Trees(const std::string& attributes, const std::string& text) {
    return "<root BTCPP_format='4' main_tree_to_execute='Main'><BehaviorTree ID='Main'><Sequence>"
           "<Repeat num_cycles='{t}'><AlwaysSuccess/></Repeat><SubTree ID='S' " +
           attributes + "/></Sequence></BehaviorTree><BehaviorTree ID='S'><Repeat num_cycles='" +
           text +
           "'><AlwaysSuccess/></Repeat></BehaviorTree><TreeNodesModel><SubTree ID='S'>"
           "<input_port name='p' default='{t}'/></SubTree></TreeNodesModel></root>";
  }
  static void ExpectKeys(std::size_t count, const std::string& attributes,
                         const std::string& text) {
    const std::string xml = Trees(attributes, text);
    EXPECT_EQ(KeysOfEngine(xml), count) << xml;
    EXPECT_EQ(KeysOfEditor(xml), count) << xml;
  }
};

TEST_F(EngineAndEditorTest, AgreeOnTheSpellingsOfAutoremap) {
  ExpectKeys(1, "_autoremap='True'", "{t}");
  ExpectKeys(2, "_autoremap='False'", "{t}");
  ExpectKeys(2, "_autoremap='true'", "{_t}");
}

TEST_F(EngineAndEditorTest, AgreeOnBlanksAroundAKey) {
  ExpectKeys(1, "_autoremap='1'", " { t } ");
  ExpectKeys(1, "a=' {t} '", "{a}");
}

TEST_F(EngineAndEditorTest, AgreeOnTheKeyWithTheNameOfThePort) {
  ExpectKeys(1, "t='='", "{t}");
  ExpectKeys(2, "num_cycles='{=}'", "=");
}

TEST_F(EngineAndEditorTest, AgreeOnALiteralGivenToASubTree) {
  ExpectKeys(2, "_autoremap='true' t='3'", "{t}");
}

TEST_F(EngineAndEditorTest, AgreeOnTheDefaultsOfASubTreesModel) {
  ExpectKeys(1, "", "{p}");
  ExpectKeys(2, "_autoremap='true'", "{p}");
  ExpectKeys(2, "p='3'", "{p}");
}

TEST(KeyUses, AreFoundInScriptsAndGuardsToo) {
  const Forest forest = ReadForest(R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>
    <Script code="left := 3; tries += 1"/>
    <Use in="{left}" _skipIf="tries > 2"/>
    <SubTree ID="Inner" rest="{left}"/>
  </Sequence></BehaviorTree>
  <BehaviorTree ID="Inner"><Script code="rest = rest - 1"/></BehaviorTree>
  <TreeNodesModel><Action ID="Use"><input_port name="in"/></Action></TreeNodesModel></root>)");
  NodeModels models;
  models.AddFrom(*forest.documents()[0]);
  const Scene scene = BuildScene(forest, 0, models);
  const KeyUses uses = FindKeyUses(scene);
  const auto text = [&](const char* name) {
    const auto key = std::find(uses.names.begin(), uses.names.end(), name) - uses.names.begin();
    std::string all;
    for (const KeyUse& use : uses.uses.at(static_cast<std::size_t>(key))) {
      all += scene.nodes[use.node].path + (use.reads ? " reads" : "") +
             (use.writes ? " writes" : "") + ", ";
    }
    return all;
  };
  EXPECT_EQ(text("left"), "1.1 writes, 1.2 reads, 1.3, 1.3.1 reads writes, ");
  EXPECT_EQ(text("tries"), "1.1 reads writes, 1.2 reads, ");
}

}  // namespace
}  // namespace coppice::editor
