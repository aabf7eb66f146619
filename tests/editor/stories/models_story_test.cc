#include <gtest/gtest.h>

#include "tests/editor/driver.h"
#include "tests/editor/reference_picture.h"

namespace coppice::editor {
namespace {

constexpr char kNavigation[] = R"(<root BTCPP_format="4" main_tree_to_execute="Go">
  <BehaviorTree ID="Go">
    <Sequence name="go">
      <RateController hz="1.0"><ComputePathToPose goal="{goal}" path="{path}"/></RateController>
      <FollowPath path="{path}"/>
      <Spin spin_dist="1.57"/>
    </Sequence>
  </BehaviorTree>
</root>
)";

constexpr char kUnknown[] = R"(<root BTCPP_format="4" main_tree_to_execute="Go">
  <BehaviorTree ID="Go">
    <Sequence name="go"><Fly to="moon"/><Land/><Hoist flag="own"/></Sequence>
  </BehaviorTree>
</root>
)";

constexpr char kModels[] = R"(<root BTCPP_format="4"><TreeNodesModel>
  <Action ID="Fly"><input_port name="to" type="string"/></Action><Action ID="Land"/>
  <Action ID="Hoist"><input_port name="flag" type="string"/></Action>
</TreeNodesModel></root>
)";

TEST(ModelsStory, NodesOfNav2AreKnownWithoutAModel) {
  const TemporaryFile file("go.xml", kNavigation);
  Driver driver;
  driver.editor.Open(file.path());
  driver.OpenRow();
  driver.Frames(8);
  EXPECT_FALSE(driver.Has("problems/0"));
  ASSERT_TRUE(driver.Click("types/filter"));
  driver.Type("undock");
  EXPECT_TRUE(driver.Has("types/UndockRobot"));
  driver.Press(kKeyEscape);
  ASSERT_TRUE(driver.Click("canvas/Go/1.3"));
  EXPECT_TRUE(driver.Has("inspector/port/time_allowance"));
  EXPECT_EQ(CompareWithReference(driver.editor.Picture(), "story_nav2"), "");
}

TEST(ModelsStory, TypesWithoutAModelAreOneRowThatLoadsOne) {
  const TemporaryFile file("go.xml", kUnknown);
  const TemporaryFile models("models.xml", kModels);
  Driver driver;
  driver.editor.Open(file.path());
  driver.OpenRow();
  driver.Frames(8);
  ASSERT_TRUE(driver.Has("problems/0"));
  EXPECT_FALSE(driver.Has("problems/1"));
  EXPECT_EQ(CompareWithReference(driver.editor.Picture(), "story_without_models"), "");
  ASSERT_TRUE(driver.Click("problems/0/fix/0"));
  driver.Type(models.path());
  driver.Press(kKeyEnter);
  driver.Frames(8);
  EXPECT_FALSE(driver.Has("problems/0"));
}

TEST(ModelsStory, ANewFileHasNoProblemAndAFixLeadsIntoTheEmptyField) {
  Driver driver;
  driver.Press('N', kCtrl);
  driver.Frames(8);
  EXPECT_TRUE(driver.editor.state().workspace.files()[0].problems.empty());
  driver.Press(kKeyTab);
  driver.Type("Delay");
  driver.Press(kKeyEnter);
  driver.Press(kKeyTab);
  driver.Type("AlwaysSuccess");
  driver.Press(kKeyEnter);
  driver.OpenRow();
  driver.Frames(8);
  ASSERT_TRUE(driver.Has("problems/0/fix/0")) << "Delay needs its port";
  ASSERT_TRUE(driver.Click("problems/0/fix/0"));
  driver.Frames(4);
  driver.Type("250");
  driver.Press(kKeyEnter);
  driver.Frames(8);
  EXPECT_FALSE(driver.Has("problems/0"));
  EXPECT_NE(driver.editor.state().workspace.project().files().begin()->second.text.find(
                "<Delay delay_msec=\"250\">"),
            std::string::npos);
}

}  // namespace
}  // namespace coppice::editor
