#include "editor/workspace/project_editor.h"

#include <gmock/gmock.h>

#include "tests/editor/driver.h"

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

TEST_F(ProjectEditorTest, LeadsToTheDefinition) {
  Select("1.3");
  EXPECT_FALSE(Edit().GoToDefinition());
  Select("1.2");
  EXPECT_EQ(Edit().GoToDefinition().problem(), "");
  EXPECT_EQ(driver_.editor.state().workspace.ShownTreeId(), "Walk");
}

}  // namespace
}  // namespace coppice::editor
