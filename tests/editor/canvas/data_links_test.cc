#include "editor/canvas/data_links.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

constexpr char kFile[] = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <Sequence>
      <Choose goal="{goal}"/>
      <Fallback><Go to="{goal}"/><Go to="{other}"/></Fallback>
      <Say/>
    </Sequence>
  </BehaviorTree>
  <TreeNodesModel>
    <Action ID="Choose"><output_port name="goal"/></Action>
    <Action ID="Go"><input_port name="to"/></Action>
    <Action ID="Say"/>
  </TreeNodesModel>
</root>
)";

class DataLinksTest : public testing::Test {
 protected:
  DataLinksTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames(30);
  }
  std::uint32_t Node(const std::string& path) { return driver_.view().scene()->FindPath(path); }
  std::uint32_t KeyOfNode(const std::string& path) {
    const auto& uses = driver_.view().keys().uses;
    for (std::uint32_t key = 0; key < uses.size(); ++key) {
      for (const KeyUse& use : uses[key]) {
        if (use.node == Node(path)) return key;
      }
    }
    return kNoKey;
  }
  // Pixels of the key's colour on the canvas, outside of the nodes that use it.
  int Painted(const std::string& key) {
    driver_.Frames(30);
    const Color color = GetPalette(PaletteName::kDark).OfKey(key);
    const Box from = driver_.BoxOf("canvas/Main/1.1");
    const Box to = driver_.BoxOf("canvas/Main/1.2.1");
    const Box between = {{std::min(from.min.x, to.min.x), from.max.y},
                         {std::max(from.max.x, to.max.x), to.min.y}};
    return driver_.CountColor(between, color, 30);
  }

  TemporaryFile file_{"keys.xml", kFile};
  Driver driver_;
};

TEST_F(DataLinksTest, ALitKeyIsLitWhereItIsUsed) {
  EXPECT_TRUE(IsLit(driver_.view(), Node("1.3"))) << "without a lit key everything is";
  driver_.view().LightKey(KeyOfNode("1.1"));
  EXPECT_TRUE(IsLit(driver_.view(), Node("1.1")));
  EXPECT_TRUE(IsLit(driver_.view(), Node("1.2.1")));
  EXPECT_FALSE(IsLit(driver_.view(), Node("1.2.2"))) << "another key";
  EXPECT_FALSE(IsLit(driver_.view(), Node("1.3")));
  EXPECT_FALSE(IsLit(driver_.view(), Node("1.2")));
  driver_.view().SetCollapsed(Node("1.2"), true, 0);
  EXPECT_TRUE(IsLit(driver_.view(), Node("1.2"))) << "it hides one that uses it";
}

TEST_F(DataLinksTest, ALineLeadsFromTheWriterToTheReader) {
  const int before = Painted("goal");
  driver_.view().LightKey(KeyOfNode("1.1"));
  EXPECT_GT(Painted("goal"), before + 20);
}

}  // namespace
}  // namespace coppice::editor
