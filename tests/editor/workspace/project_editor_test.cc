#include "editor/workspace/project_editor.h"

#include <gmock/gmock.h>

#include "tests/editor/driver.h"
#include "tests/support/temporary_folder.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ProjectEditorTest : public testing::Test {
 protected:
  ProjectEditorTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }
  ProjectEditor Edit() { return ProjectEditor(driver_.editor.state(), driver_.editor.now()); }
  const std::string& Text() {
    return driver_.editor.state().workspace.project().Find(file_.path())->text;
  }
  void Select(const std::string& path) {
    driver_.view().Select(driver_.view().scene()->FindPath(path));
  }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(ProjectEditorTest, ATreeIsMadeShownRenamedAndDeleted) {
  EXPECT_THAT(Edit().NewTree("Walk").problem(), HasSubstr("already"));
  EXPECT_EQ(Edit().NewTree("Dock").problem(), "");
  EXPECT_EQ(driver_.editor.state().workspace.ShownTreeId(), "Dock");
  EXPECT_THAT(Text(), HasSubstr("</BehaviorTree>\n  <BehaviorTree ID=\"Dock\"/>\n  <TreeNodes"));
  EXPECT_EQ(Edit().RenameTree("Park").problem(), "");
  EXPECT_EQ(driver_.editor.state().workspace.ShownTreeId(), "Park");
  EXPECT_EQ(Edit().DeleteTree().problem(), "");
  EXPECT_EQ(Text(), kSmallFile);
}

TEST_F(ProjectEditorTest, ATreeThatIsUsedIsNotDeleted) {
  EXPECT_TRUE(Edit().ShowTree("Walk"));
  EXPECT_THAT(Edit().DeleteTree().problem(), HasSubstr("used in 1 place"));
  EXPECT_EQ(Text(), kSmallFile);
}

TEST_F(ProjectEditorTest, ExtractAndInlineAreOneStepEach) {
  Select("1.1");
  EXPECT_EQ(Edit().Extract("Light").problem(), "");
  EXPECT_THAT(Text(), HasSubstr(R"(<SubTree ID="Light" light="{light}" level="{level}"/>)"));
  EXPECT_EQ(driver_.Selected(), "1.1");
  EXPECT_EQ(Edit().Inline().problem(), "");
  EXPECT_EQ(driver_.editor.state().workspace.project().history().done(), 2U);
  driver_.Press('Z', kCtrl);
  driver_.Press('Z', kCtrl);
  EXPECT_EQ(Text(), kSmallFile);
}

TEST_F(ProjectEditorTest, TheKeysOfTheSelectionAreRenamedEverywhere) {
  Select("1.2.1.1");
  EXPECT_THAT(Edit().SelectedKeys(), ElementsAre("goal"));
  EXPECT_EQ(Edit().RenameKey("goal", "place").problem(), "");
  EXPECT_THAT(Text(), HasSubstr(R"(<Step to="{place}"/>)"));
  EXPECT_THAT(Text(), HasSubstr(R"(name="walk" place="{goal}"/>)"));
  EXPECT_EQ(driver_.Selected(), "1.2.1.1");
}

TEST_F(ProjectEditorTest, AFileIsIncludedAndMadeIfItIsNotThere) {
  EXPECT_EQ(Edit().Include("more.xml").problem(), "");
  EXPECT_THAT(Text(), HasSubstr(R"(<include path="more.xml"/>)"));
  EXPECT_EQ(Edit().Files().size(), 2U);
  EXPECT_TRUE(std::filesystem::exists(file_.folder() + "/more.xml"));
  driver_.Press('Z', kCtrl);
  EXPECT_EQ(Text(), kSmallFile);
}

TEST_F(ProjectEditorTest, AFileToIncludeIsChosenFromAListAndWrittenAsSeenFromHere) {
  WriteFile(file_.folder() + "/beside.xml", R"(<root BTCPP_format="4"/>)");
  driver_.editor.state().commands.Run("file.include");
  driver_.Frames();
  EXPECT_EQ(driver_.editor.state().popup.kind, Popup::kOpen);
  driver_.Type("beside.xml");
  driver_.Frames();
  driver_.Press(kKeyEnter);
  driver_.Frames();
  EXPECT_THAT(Text(), HasSubstr(R"(<include path="beside.xml"/>)"));
}

TEST_F(ProjectEditorTest, LeadsToTheDefinition) {
  Select("1.3");
  EXPECT_FALSE(Edit().GoToDefinition());
  Select("1.2");
  EXPECT_EQ(Edit().GoToDefinition().problem(), "");
  EXPECT_EQ(driver_.editor.state().workspace.ShownTreeId(), "Walk");
}

// A robot that reads a folder of trees, each in a file that includes nothing.
class FilesBesideTest : public testing::Test {
 protected:
  FilesBesideTest() {
    WriteFile(pick_, R"(<root BTCPP_format="4"><BehaviorTree ID="Pick"><Sequence>)"
                     R"(<SubTree ID="Open Gripper"/></Sequence></BehaviorTree></root>)");
    WriteFile(gripper_, R"(<root BTCPP_format="4"><BehaviorTree ID="Open Gripper">)"
                        R"(<AlwaysSuccess name="wide"/></BehaviorTree></root>)");
    driver_.editor.Open(pick_);
    driver_.Frames();
  }
  Workspace& workspace() { return driver_.editor.state().workspace; }
  ProjectEditor Edit() { return ProjectEditor(driver_.editor.state(), driver_.editor.now()); }
  void SelectSubTree() { driver_.view().Select(driver_.view().scene()->FindPath("1.1")); }

  const TemporaryFolder folder_;
  const std::string pick_ = folder_.Path("pick.xml");
  const std::string gripper_ = folder_.Path("open_gripper.xml");
  Driver driver_;
};

TEST_F(FilesBesideTest, TheOneThatHasTheTreeOfASubTreeIsOpenedWhenTheUserGoesThere) {
  SelectSubTree();
  EXPECT_EQ(Edit().GoToDefinition().problem(), "");
  EXPECT_EQ(workspace().ShownTreeId(), "Open Gripper");
  EXPECT_EQ(workspace().file()->path, gripper_);
  EXPECT_EQ(workspace().files().size(), 2U);
}

TEST_F(FilesBesideTest, ATreeOfAnotherOpenFileIsNotMissing) {
  ASSERT_EQ(workspace().files()[0].problems.size(), 1U);
  driver_.editor.Open(gripper_);
  driver_.Frames();
  EXPECT_TRUE(workspace().files()[0].problems.empty());
  EXPECT_TRUE(workspace().files()[1].problems.empty());
  workspace().ShowFileTree(0, 0, driver_.editor.now());
  EXPECT_NE(driver_.view().scene()->FindPath("1.1.1"), kNoSceneNode) << "it is written out";
}

TEST_F(FilesBesideTest, ATreeIsRenamedInAllOpenFilesThatUseIt) {
  driver_.editor.Open(gripper_);
  driver_.Frames();
  EXPECT_EQ(Edit().RenameTree("Open").problem(), "");
  EXPECT_THAT(workspace().project().Find(pick_)->text, HasSubstr(R"(<SubTree ID="Open"/>)"));
  EXPECT_THAT(workspace().project().Find(gripper_)->text, HasSubstr(R"(ID="Open">)"));
}

}  // namespace
}  // namespace coppice::editor
