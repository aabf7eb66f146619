#include <gmock/gmock.h>

#include "tests/editor/driver.h"
#include "tests/editor/reference_picture.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;

constexpr char kFile[] = R"(<root BTCPP_format="4" main_tree_to_execute="Errand">
  <BehaviorTree ID="Errand">
    <Sequence name="errand">
      <Fetch what="cup" from="{shelf}"/>
      <SubTree ID="Bring"/>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Bring">
    <Fetch what="{thing}" from="table"/>
  </BehaviorTree>
</root>
)";

class DefineTypeStory : public testing::Test {
 protected:
  DefineTypeStory() {
    driver_.editor.Open(file_.path());
    driver_.Frames(8);
  }
  std::string Text() { return driver_.editor.state().workspace.project().Find(file_.path())->text; }
  void Fill(const std::string& item, const std::string& text) {
    ASSERT_TRUE(driver_.Click(item)) << item;
    driver_.Press('A', kCtrl);
    driver_.Type(text);
    driver_.Press(kKeyEnter);
  }

  TemporaryFile file_{"errand.xml", kFile};
  Driver driver_;
};

TEST_F(DefineTypeStory, DefinesATypeWithoutXml) {
  ASSERT_TRUE(driver_.Click("canvas/Errand/1.1"));
  ASSERT_TRUE(driver_.Click("inspector/edit_type"));
  Fill("inspector/type/description", "Takes a thing from a place.");
  Fill("inspector/type/port/0/description", "the thing");
  Fill("inspector/type/port/1/type", "Pose2D");
  ASSERT_TRUE(driver_.Click("inspector/type/new_port"));
  driver_.Type("grip");
  driver_.Press(kKeyEnter);
  ASSERT_TRUE(driver_.Click("inspector/type/port/2/direction"));
  Fill("inspector/type/port/2/type", "double");
  EXPECT_THAT(Text(), HasSubstr(R"(  <TreeNodesModel>
    <Action ID="Fetch">
      <input_port name="what" type="string">the thing</input_port>
      <input_port name="from" type="Pose2D"/>
      <output_port name="grip" type="double"/>
      <MetadataFields><Metadata description="Takes a thing from a place."/></MetadataFields>
    </Action>
  </TreeNodesModel>
)"));
  driver_.Frames(250);  // the notice is gone
  EXPECT_EQ(CompareWithReference(driver_.editor.Picture(), "story_define_type"), "");
  ASSERT_TRUE(driver_.Click("inspector/type/done"));
  EXPECT_TRUE(driver_.Has("inspector/port/grip")) << "the node has the new port at once";
  ASSERT_TRUE(driver_.Click("types/filter"));
  driver_.Type("Fetch");
  EXPECT_TRUE(driver_.Has("types/Fetch"));
  driver_.Press(kKeyEscape);
  ASSERT_TRUE(driver_.Click("canvas/Errand/1.1"));
  while (driver_.editor.state().workspace.project().history().done() > 0) {
    driver_.Press('Z', kCtrl);
  }
  EXPECT_EQ(Text(), kFile);
}

TEST_F(DefineTypeStory, GivesASubTreeItsPorts) {
  ASSERT_TRUE(driver_.Click("canvas/Errand/1.2"));
  Fill("inspector/port/thing", "{cup}");
  EXPECT_THAT(Text(), HasSubstr(R"(<SubTree ID="Bring" thing="{cup}"/>)"));
  ASSERT_TRUE(driver_.Click("inspector/edit_type"));
  Fill("inspector/type/port/0/default", "cup");
  EXPECT_THAT(Text(), HasSubstr(R"(    <SubTree ID="Bring">
      <input_port name="thing" default="cup"/>
    </SubTree>)"));
  ASSERT_TRUE(driver_.Click("inspector/type/done"));
  driver_.Frames(250);
  EXPECT_EQ(CompareWithReference(driver_.editor.Picture(), "story_subtree_ports"), "");
}

}  // namespace
}  // namespace coppice::editor
