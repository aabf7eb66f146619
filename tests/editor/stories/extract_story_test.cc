#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/editor/driver.h"
#include "tests/editor/reference_picture.h"

namespace coppice::editor {
namespace {

constexpr char kFile[] = R"(<root BTCPP_format="4" main_tree_to_execute="Round">
  <BehaviorTree ID="Round">
    <Sequence name="round">
      <ChooseGoal goal="{goal}"/>
      <Sequence name="go there">
        <PlanPath to="{goal}" path="{path}"/>
        <FollowPath path="{path}" driven="{metres}"/>
      </Sequence>
      <Report goal="{goal}" metres="{metres}"/>
    </Sequence>
  </BehaviorTree>
  <TreeNodesModel>
    <Action ID="ChooseGoal"><output_port name="goal" type="string"/></Action>
    <Action ID="PlanPath"><input_port name="to" type="string"/>
      <output_port name="path" type="string"/></Action>
    <Action ID="FollowPath"><input_port name="path" type="string"/>
      <output_port name="driven" type="double"/></Action>
    <Action ID="Report"><input_port name="goal" type="string"/>
      <input_port name="metres" type="double"/></Action>
  </TreeNodesModel>
</root>
)";

TEST(ExtractStory, ExtractsASubTreeAndSeesItsPorts) {
  const TemporaryFile file("round.xml", kFile);
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames(8);
  ASSERT_TRUE(driver.Click("canvas/Round/1.2"));
  driver.Press('E', kCtrl);
  driver.Type("GoThere");
  driver.Press(kKeyEnter);
  driver.Frames(12);
  ASSERT_TRUE(driver.Has("canvas/Round/1.2/port/goal")) << "what is read inside and known outside";
  EXPECT_TRUE(driver.Has("canvas/Round/1.2/port/metres"));
  EXPECT_FALSE(driver.Has("canvas/Round/1.2/port/path")) << "its own business";
  ASSERT_TRUE(driver.Click("canvas/Round/1.2/port/metres"));
  driver.Frames(200);  // the notice is gone
  EXPECT_EQ(CompareWithReference(driver.editor.Picture(), "story_extract"), "");

  const auto text = [&] {
    return driver.editor.state().workspace.project().Find(file.path())->text;
  };
  EXPECT_NE(text().find(R"(<SubTree ID="GoThere")"), std::string::npos) << text();
  driver.Press('Z', kCtrl);
  EXPECT_EQ(text(), kFile);
}

}  // namespace
}  // namespace coppice::editor
