// Stories: what a user does with keys, and what is in the file afterwards.
#include "editor/commands/edit_commands.h"

#include <gmock/gmock.h>

#include "tests/editor/driver.h"
#include "tests/editor/reference_picture.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;
using testing::Not;

class EditCommandsTest : public testing::Test {
 protected:
  EditCommandsTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }

  const EditedFile& File() {
    return *driver_.editor.state().workspace.project().Find(file_.path());
  }
  const std::string& Text() { return File().text; }
  const std::string& Notice() { return driver_.editor.state().notice.text; }
  std::string Disk() const {
    std::ifstream stream(file_.path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void Select(const std::string& path) {
    const Scene& scene = *driver_.view().scene();
    driver_.view().Select(scene.FindPath(path));
    driver_.Frames(1);
  }
  void Add(const std::string& typed, int modifiers = kNoModifier) {
    driver_.Press(kKeyTab);
    driver_.Type(typed);
    driver_.Press(kKeyEnter, modifiers);
  }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST(EditStory, BuildThePatrolTreeFromNothingWithTheKeyboard) {
  const TemporaryFile folder("other.xml", "");
  Driver driver;
  driver.Frames();
  const auto add = [&](const std::string& typed, int modifiers = kNoModifier) {
    driver.Press(kKeyTab);
    driver.Type(typed);
    driver.Press(kKeyEnter, modifiers);
  };
  driver.Press('N', kCtrl);
  add("Sequence");
  EXPECT_EQ(driver.Selected(), "1");
  driver.Press(kKeyF1 + 1);
  driver.Type("patrol");
  driver.Press(kKeyEnter);
  add("BatteryOk");
  EXPECT_EQ(driver.Selected(), "1.1");
  add("Repeat", kShift);
  EXPECT_EQ(driver.Selected(), "1.2");
  add("DriveTo");
  EXPECT_EQ(driver.Selected(), "1.2.1");
  driver.Press(kKeyUp);
  add("Timeout", kCtrl);
  EXPECT_EQ(driver.Selected(), "1.2");
  driver.Press(kKeyUp);
  add("Beep");
  EXPECT_EQ(driver.Selected(), "1.3");
  driver.Press(kKeyLeft, kAlt);
  EXPECT_EQ(driver.Selected(), "1.2");
  driver.Frames(200);
  EXPECT_EQ(CompareWithReference(driver.editor.Picture(), "story_build"), "");
  driver.Press('S', kCtrl);
  driver.Press('A', kCtrl);
  driver.Type(folder.folder() + "/patrol.xml");
  driver.Press(kKeyEnter);
  driver.Picture("story_patrol");
  std::ifstream stream(folder.folder() + "/patrol.xml");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_EQ(text, R"(<?xml version="1.0" encoding="UTF-8"?>
<root BTCPP_format="4" main_tree_to_execute="MainTree">
  <BehaviorTree ID="MainTree">
    <Sequence name="patrol">
      <BatteryOk/>
      <Beep/>
      <Timeout>
        <Repeat>
          <DriveTo/>
        </Repeat>
      </Timeout>
    </Sequence>
  </BehaviorTree>
</root>
)");
}

TEST_F(EditCommandsTest, UndoEverythingGivesTheSameBytes) {
  Select("1.1");
  Add("Beep");
  Select("1.1.1");
  driver_.Press('D');
  driver_.Press(kKeyRight, kAlt);
  Select("1.3");
  Add("Inverter", kCtrl);
  driver_.Press(kKeyDelete);
  Select("1.1");
  driver_.Press('R');
  driver_.Type("Sequence");
  driver_.Press(kKeyEnter);
  driver_.Press('C', kCtrl);
  driver_.Press('V', kCtrl);
  driver_.Press(kKeyDelete, kCtrl);
  EXPECT_EQ(driver_.editor.state().workspace.project().history().done(), 8U);
  EXPECT_NE(Text(), kSmallFile);
  const std::string changed = Text();
  for (int i = 0; i < 8; ++i) driver_.Press('Z', kCtrl);
  EXPECT_EQ(Text(), kSmallFile);
  EXPECT_FALSE(File().is_dirty());
  driver_.Press('Z', kCtrl);
  EXPECT_EQ(Notice(), "there is nothing to undo");
  for (int i = 0; i < 8; ++i) driver_.Press('Z', kCtrl | kShift);
  EXPECT_EQ(Text(), changed);
}

TEST_F(EditCommandsTest, APasteWithErrorsShowsThemAndPastesNothing) {
  Select("1.1");
  driver_.editor.state().services.set_clipboard("<Beep>\n<Beep/>");
  driver_.Press('V', kCtrl);
  EXPECT_EQ(Text(), kSmallFile);
  EXPECT_TRUE(driver_.Has("popup/error/0"));
  driver_.Picture("paste_errors");
  driver_.Press(kKeyEscape);
  EXPECT_FALSE(driver_.Has("popup"));
}

TEST_F(EditCommandsTest, PasteTakesXmlOfAnyTextEditor) {
  Select("1.1");
  driver_.editor.state().services.set_clipboard("  <Beep tone=\"a\"/>\n  <Beep/>\n");
  driver_.Press('V', kCtrl);
  EXPECT_THAT(Text(), HasSubstr("level=\"{level}\"/>\n        <Beep tone=\"a\"/>\n"
                                "        <Beep/>\n      </Fallback>"));
  driver_.Press('V', kCtrl | kShift);
  EXPECT_EQ(driver_.editor.state().workspace.project().history().done(), 2U);
}

TEST_F(EditCommandsTest, CutAndPasteMovesANode) {
  Select("1.1.2");
  driver_.Press('X', kCtrl);
  EXPECT_THAT(Text(), Not(HasSubstr("<SwitchOn lamp")));
  Select("1");
  driver_.Press('V', kCtrl);
  EXPECT_EQ(driver_.Selected(), "1.4");
  EXPECT_THAT(Text(), HasSubstr("<AlwaysSuccess/>\n      <SwitchOn lamp"));
}

TEST_F(EditCommandsTest, UndoIsNamedAndSelectsWhatWasSelected) {
  Select("1.1.2");
  driver_.Press(kKeyDelete);
  EXPECT_EQ(driver_.Selected(), "1.1.1");
  driver_.Press('Z', kCtrl);
  EXPECT_EQ(Notice(), "Undone: Delete SwitchOn");
  EXPECT_EQ(driver_.Selected(), "1.1.2");
}

TEST_F(EditCommandsTest, ALeafGetsASiblingInsteadOfAChild) {
  Select("1.3");
  driver_.Press(kKeySpace);
  EXPECT_TRUE(driver_.Has("popup/help"));
  driver_.Picture("add_popup");
  driver_.Type("Fallback");
  driver_.Press(kKeyEnter);
  EXPECT_EQ(driver_.Selected(), "1.4");
}

TEST_F(EditCommandsTest, WhatIsNotPossibleIsSaidAndTheTextStays) {
  Select("1");
  driver_.Press(kKeyDelete, kCtrl);
  EXPECT_THAT(Notice(), HasSubstr("one root node"));
  EXPECT_EQ(Text(), kSmallFile);
  EXPECT_TRUE(driver_.Has("notice"));
}

TEST_F(EditCommandsTest, NodesOfASubTreeAreEditedWhereItIsDefined) {
  Select("1.2.1");
  driver_.Press(kKeyF1 + 1);
  driver_.Type("again");
  driver_.Press(kKeyEnter);
  EXPECT_THAT(Text(), HasSubstr(R"(<RetryUntilSuccessful num_attempts="3" name="again">)"));
  EXPECT_EQ(driver_.Selected(), "1.2.1");
}

TEST_F(EditCommandsTest, SeveralNodesAreChangedInOneStep) {
  const Scene& scene = *driver_.view().scene();
  driver_.view().SelectAll({scene.FindPath("1.1.1"), scene.FindPath("1.3")});
  driver_.Press(kKeyDelete);
  EXPECT_THAT(Text(), Not(HasSubstr("<Inverter>")));
  EXPECT_THAT(Text(), Not(HasSubstr("<AlwaysSuccess/>")));
  driver_.Press('Z', kCtrl);
  EXPECT_EQ(Notice(), "Undone: Delete 2 nodes");
  EXPECT_EQ(Text(), kSmallFile);
  EXPECT_EQ(driver_.view().selection().size(), 2U);
}

TEST_F(EditCommandsTest, SaveWritesOnlyWhatWasTouched) {
  Select("1.3");
  driver_.Press('D');
  EXPECT_TRUE(File().is_dirty());
  driver_.Press('S', kCtrl);
  EXPECT_FALSE(File().is_dirty());
  std::string expected = kSmallFile;
  const std::string node = "<AlwaysSuccess";
  expected.insert(expected.find(node) + node.size(), R"( _skipIf="true")");
  EXPECT_EQ(Disk(), expected);
}

TEST_F(EditCommandsTest, DuplicateLeavesTheClipboardAloneAndSelectsTheCopy) {
  driver_.editor.state().services.set_clipboard("mine");
  Select("1.1.2");
  driver_.Press('D', kCtrl);
  EXPECT_EQ(driver_.Selected(), "1.1.3");
  const std::string node = R"(<SwitchOn lamp="hall" level="{level}"/>)";
  const std::size_t first = Text().find(node);
  EXPECT_NE(Text().find(node, first + 1), std::string::npos);
  EXPECT_EQ(driver_.editor.state().services.get_clipboard(), "mine");
}

TEST_F(EditCommandsTest, SelectAllTakesTheNodesOfTheShownTreeOnly) {
  driver_.Press('A', kCtrl);
  const auto& nodes = driver_.view().scene()->nodes;
  for (const std::uint32_t node : driver_.view().selection()) EXPECT_EQ(nodes[node].scope, 0u);
  EXPECT_EQ(driver_.view().selection().size(), 7u);
}

TEST_F(EditCommandsTest, RedoIsOnTheKeysOfBothHabits) {
  Select("1.3");
  driver_.Press('D');
  const std::string done = Text();
  driver_.Press('Z', kCtrl);
  driver_.Press('Y', kCtrl);
  EXPECT_EQ(Text(), done);
}

TEST_F(EditCommandsTest, ADisabledNodeIsNoProblemForTheChecker) {
  const std::size_t before = driver_.editor.state().workspace.file()->problems.size();
  Select("1.3");
  driver_.Press('D');
  driver_.Frames(10);
  EXPECT_EQ(driver_.editor.state().workspace.file()->problems.size(), before);
}

TEST_F(EditCommandsTest, AChangedFileIsReadAgainAndADirtyOneIsKept) {
  std::string other = kSmallFile;
  other.replace(other.find("AlwaysSuccess"), 13, "AlwaysFailure");
  file_.Write(other);
  driver_.Frames(60);
  EXPECT_EQ(Text(), other);
  Select("1.3");
  driver_.Press('D');
  const std::string mine = Text();
  other.replace(other.find("AlwaysFailure/>"), 15, R"(AlwaysFailure _skipIf="late"/>)");
  file_.Write(other);
  driver_.Frames(60);
  EXPECT_EQ(Text(), mine);
  EXPECT_THAT(Notice(), HasSubstr("in the same places"));
  driver_.Press('S', kCtrl);
  EXPECT_TRUE(File().is_dirty());
  driver_.editor.state().commands.Run("file.save_over");
  EXPECT_EQ(Disk(), mine);
}

TEST_F(EditCommandsTest, ChangesOfOthersInOtherPlacesAreMerged) {
  Select("1.3");
  driver_.Press('D');
  std::string other = kSmallFile;
  other.replace(other.find(R"(lamp="hall")"), 11, R"(lamp="attic")");
  file_.Write(other);
  driver_.Frames(60);
  EXPECT_THAT(Notice(), HasSubstr("merged"));
  EXPECT_THAT(Text(), HasSubstr(R"(lamp="attic")"));
  EXPECT_THAT(Text(), HasSubstr(R"(<AlwaysSuccess _skipIf="true"/>)"));
  driver_.Press('S', kCtrl);
  EXPECT_EQ(Disk(), Text());
}

TEST_F(EditCommandsTest, MergingKeepsMineWhereBothChanged) {
  Select("1.3");
  driver_.Press('D');
  std::string other = kSmallFile;
  other.replace(other.find(R"(lamp="hall")"), 11, R"(lamp="attic")");
  other.replace(other.find("<AlwaysSuccess/>"), 16, R"(<AlwaysSuccess _skipIf="late"/>)");
  file_.Write(other);
  driver_.Frames(60);
  driver_.editor.state().commands.Run("file.merge");
  EXPECT_THAT(Notice(), HasSubstr("1 places"));
  EXPECT_THAT(Text(), HasSubstr(R"(lamp="attic")"));
  EXPECT_THAT(Text(), HasSubstr(R"(<AlwaysSuccess _skipIf="true"/>)"));
}

TEST_F(EditCommandsTest, ARobotsTreeIsNotChanged) {
  driver_.AddRobot("robot:1", kLiveTree);
  Select("1.1");
  driver_.Press(kKeyDelete);
  EXPECT_THAT(Notice(), HasSubstr("robot"));
  driver_.Press(kKeyTab);
  EXPECT_FALSE(driver_.Has("popup"));
}

TEST_F(EditCommandsTest, AMalformedFileKeepsItsLastTreeButIsNotChanged) {
  Workspace& workspace = driver_.editor.state().workspace;
  workspace.project().SetText(file_.path(), "Type", "<root><BehaviorTree ID=");
  workspace.Refresh(1);
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("canvas/MainTree/1"));
  Select("1.3");
  driver_.Press(kKeyDelete);
  EXPECT_THAT(Notice(), HasSubstr("malformed"));
  driver_.Press('Z', kCtrl);
  EXPECT_EQ(Text(), kSmallFile);
}

}  // namespace
}  // namespace coppice::editor
