// Stories about whole trees and names, told with the keyboard.
#include "editor/commands/project_commands.h"

#include <gmock/gmock.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;
using testing::Not;

class ProjectCommandsTest : public testing::Test {
 protected:
  ProjectCommandsTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }
  const std::string& Text() {
    return driver_.editor.state().workspace.project().Find(file_.path())->text;
  }
  void Select(const std::string& path) {
    driver_.view().Select(driver_.view().scene()->FindPath(path));
    driver_.Frames(1);
  }
  // What a prompt opens with is selected: typing replaces it.
  void Answer(const std::string& text) {
    driver_.Type(text);
    driver_.Press(kKeyEnter);
  }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(ProjectCommandsTest, ExtractASubTreeAndSeeItsPorts) {
  Select("1.1");
  driver_.Press('E', kCtrl);
  Answer("Light");
  EXPECT_TRUE(driver_.Has("inspector/port/light"));
  EXPECT_TRUE(driver_.Has("inspector/port/level"));
  driver_.Picture("story_extract");
  driver_.Press(kKeyF1 + 11);
  EXPECT_EQ(driver_.editor.state().workspace.ShownTreeId(), "Light");
}

TEST_F(ProjectCommandsTest, ANameThatIsTakenIsRefusedInThePrompt) {
  Select("1.1");
  driver_.Press('E', kCtrl);
  Answer("Walk");
  EXPECT_TRUE(driver_.Has("popup"));
  EXPECT_THAT(driver_.editor.state().popup.error, HasSubstr("already"));
  EXPECT_EQ(Text(), kSmallFile);
  driver_.Press(kKeyEscape);
  EXPECT_FALSE(driver_.Has("popup"));
}

TEST_F(ProjectCommandsTest, FindLeadsToTheNode) {
  driver_.Press('F', kCtrl);
  driver_.Type("key:goal");
  EXPECT_TRUE(driver_.Has("popup/1"));
  EXPECT_FALSE(driver_.Has("popup/2"));
  driver_.Picture("find");
  driver_.Press(kKeyDown);
  driver_.Press(kKeyEnter);
  EXPECT_EQ(driver_.Selected(), "1.2.1.1");
}

TEST_F(ProjectCommandsTest, FindNextGoesRoundAndBack) {
  driver_.Press('F', kCtrl);
  driver_.Type("key:goal");
  driver_.Press(kKeyEnter);
  EXPECT_EQ(driver_.Selected(), "1.2");
  driver_.Press(kKeyF1 + 2);
  EXPECT_EQ(driver_.Selected(), "1.2.1.1");
  driver_.Press(kKeyF1 + 2);
  EXPECT_EQ(driver_.Selected(), "1.2");
  driver_.Press(kKeyF1 + 2, kShift);
  EXPECT_EQ(driver_.Selected(), "1.2.1.1");
}

TEST_F(ProjectCommandsTest, FindZoomsToWhatCouldNotBeRead) {
  driver_.view().camera.zoom = 0.2F;
  driver_.Press('F', kCtrl);
  driver_.Type("key:goal");
  driver_.Press(kKeyEnter);
  EXPECT_GE(driver_.view().camera.zoom, 0.6F);
}

TEST_F(ProjectCommandsTest, ReplaceLeavesOutWhatWasClicked) {
  driver_.Press('H', kCtrl);
  Answer("value:goal");
  driver_.Type("place");
  driver_.Picture("replace");
  ASSERT_TRUE(driver_.Click("popup/1"));
  driver_.Press(kKeyEnter);
  EXPECT_THAT(Text(), HasSubstr(R"(goal="{place}")"));
  EXPECT_THAT(Text(), HasSubstr(R"(<Step to="{goal}"/>)"));
}

TEST_F(ProjectCommandsTest, TheHistoryGoesToAnyStep) {
  Select("1.3");
  driver_.Press('D');
  const std::string first = Text();
  driver_.Press(kKeyDelete);
  Select("1.1");
  driver_.Press(kKeyDelete);
  driver_.Press('H', kCtrl | kShift);
  driver_.Picture("history");
  driver_.Type("disable");
  driver_.Press(kKeyEnter);
  EXPECT_EQ(Text(), first);
  driver_.Press('H', kCtrl | kShift);
  driver_.Type("opened");
  driver_.Press(kKeyEnter);
  EXPECT_EQ(Text(), kSmallFile);
  EXPECT_EQ(driver_.editor.state().workspace.project().history().steps().size(), 3U);
}

TEST_F(ProjectCommandsTest, NodeModelsAreLoadedFromAFile) {
  const TemporaryFile models("models.xml",
                             R"(<root BTCPP_format="4"><TreeNodesModel><Action ID="Step">)"
                             R"(<input_port name="to"/></Action></TreeNodesModel></root>)");
  const auto dialog = [this] { return driver_.editor.state().popup.kind == Popup::kOpen; };
  driver_.editor.state().commands.Run("file.models");
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("popup/0")) << "the folder is listed";
  Answer("/nowhere.xml");
  EXPECT_TRUE(dialog());
  driver_.Press(kKeyEnter);  // the same once more
  EXPECT_TRUE(dialog());
  driver_.Press('A', kCtrl);
  Answer(models.path());
  EXPECT_FALSE(dialog());
  driver_.Frames(5);
  const Scene& scene = *driver_.view().scene();
  EXPECT_EQ(scene.nodes[scene.FindPath("1.2.1.1")].shape, Shape::kAction);
  EXPECT_TRUE(driver_.editor.state().workspace.file()->problems.empty());
}

TEST_F(ProjectCommandsTest, ARobotSaysWhatItsNodesAre) {
  driver_.AddRobot("robot:1", kLiveTree);
  driver_.editor.state().workspace.ShowFileTree(0, 0, driver_.editor.now());
  driver_.Frames(5);
  const Scene& scene = *driver_.view().scene();
  EXPECT_EQ(scene.nodes[scene.FindPath("1.2.1.1")].shape, Shape::kAction);
}

TEST_F(ProjectCommandsTest, AKeyIsRenamedEverywhere) {
  Select("1.1.2");
  driver_.Press('K', kCtrl | kShift);
  Answer("brightness");
  EXPECT_THAT(Text(), HasSubstr(R"(level="{brightness}")"));
  driver_.Press('Z', kCtrl);
  EXPECT_EQ(Text(), kSmallFile);
}

TEST_F(ProjectCommandsTest, UsagesOfATypeAreListed) {
  Select("1.2");
  driver_.Press(kKeyF1 + 11, kShift);
  EXPECT_TRUE(driver_.Has("popup/0"));
  EXPECT_FALSE(driver_.Has("popup/1"));
  driver_.Press(kKeyEnter);
  EXPECT_EQ(driver_.Selected(), "1.2");
}

TEST_F(ProjectCommandsTest, ATreeIsRenamedWhereItIsUsed) {
  Select("1.2");
  driver_.Press(kKeyF1 + 11);
  driver_.Press(kKeyF1 + 1, kCtrl);
  Answer("Stroll");
  EXPECT_THAT(Text(), HasSubstr(R"(<SubTree ID="Stroll")"));
  EXPECT_THAT(Text(), HasSubstr(R"(<BehaviorTree ID="Stroll">)"));
  EXPECT_THAT(Text(), Not(HasSubstr("Walk")));
}

}  // namespace
}  // namespace coppice::editor
