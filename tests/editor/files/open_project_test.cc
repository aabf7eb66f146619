#include "editor/files/open_project.h"

#include <gmock/gmock.h>

#include "editor/document/tree_edits.h"
#include "tests/editor/document/drafts.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string ReadFile(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class OpenProjectTest : public testing::Test {
 protected:
  OpenProjectTest() { project_.Open(path_, diagnostics_); }

  const EditedFile& file() const { return *project_.Find(path_); }

  void Delete(const std::string& name) {
    Draft draft = DraftOf(*file().document, {name});
    const std::vector<FilePlace> before = {{path_, file().document->element(kRootElement).offset}};
    ASSERT_EQ(DeleteNodes(draft).problem(), "");
    ASSERT_TRUE(
        project_.Do({"Delete " + name, {std::move(draft).Finish(path_)}}, before, diagnostics_));
  }

  // As another program does it, with another time stamp.
  void WriteFromOutside(const std::string& text) {
    file_.Write(text);
    std::filesystem::last_write_time(
        path_, std::filesystem::last_write_time(path_) + std::chrono::seconds(++outside_));
  }

  TemporaryFile file_{"round.xml", kRound};
  const std::string path_ = file_.path();
  Diagnostics diagnostics_;
  OpenProject project_;
  int outside_ = 0;
};

TEST_F(OpenProjectTest, WhatIsWarnedOfInTheTextIsToldAfterEveryStep) {
  std::string text = kRound;
  text.insert(text.find("</BehaviorTree>"), "words");
  project_.SetText(path_, "Type", text, false);
  ASSERT_EQ(file().problems.all().size(), 1U);
  Delete("A");
  EXPECT_EQ(file().problems.all().size(), 1U);
  project_.Undo();
  EXPECT_EQ(file().problems.all().size(), 1U);
  project_.Undo();
  EXPECT_TRUE(file().problems.all().empty());
  project_.Redo();
  EXPECT_EQ(file().problems.all().size(), 1U);
}

TEST_F(OpenProjectTest, UndoAndRedoHaveNamesAndGiveTheSameBytes) {
  Delete("A");
  const std::string without_a = file().text;
  Delete("D");
  const std::string without_both = file().text;
  EXPECT_TRUE(file().is_dirty());
  EXPECT_EQ(project_.Undo()->name, "Delete D");
  EXPECT_EQ(file().text, without_a);
  EXPECT_EQ(project_.Undo()->name, "Delete A");
  EXPECT_EQ(file().text, kRound);
  EXPECT_FALSE(file().is_dirty());
  EXPECT_EQ(project_.Undo(), nullptr);
  EXPECT_EQ(project_.Redo()->name, "Delete A");
  EXPECT_EQ(project_.Redo()->name, "Delete D");
  EXPECT_EQ(file().text, without_both);
  EXPECT_EQ(file().document->text(), without_both);
  EXPECT_EQ(project_.Redo(), nullptr);
}

TEST_F(OpenProjectTest, WhatWasUndoneIsForgottenWhenSomethingElseIsDone) {
  Delete("A");
  project_.Undo();
  Delete("D");
  EXPECT_EQ(project_.Redo(), nullptr);
  EXPECT_EQ(project_.history().steps().size(), 1U);
}

TEST_F(OpenProjectTest, HistoryHasNoEnd) {
  for (int i = 0; i < 100; ++i) {
    Draft draft = DraftOf(*file().document, {"A"});
    ASSERT_TRUE(SetValue(draft, "x", std::to_string(i)));
    ASSERT_TRUE(project_.Do({"Set", {std::move(draft).Finish(path_)}}, {}, diagnostics_));
  }
  for (int i = 0; i < 100; ++i) ASSERT_NE(project_.Undo(), nullptr);
  EXPECT_EQ(file().text, kRound);
}

TEST_F(OpenProjectTest, AChangeOfSeveralFilesIsOneStep) {
  TemporaryFile other("other.xml", kRound);
  project_.Open(other.path(), diagnostics_);
  NamedChange change;
  change.name = "Both";
  for (const std::string& path : {path_, other.path()}) {
    Draft draft = DraftOf(*project_.Find(path)->document, {"A"});
    ASSERT_TRUE(DeleteNodes(draft));
    change.files.push_back(std::move(draft).Finish(path));
  }
  ASSERT_TRUE(project_.Do(std::move(change), {}, diagnostics_));
  EXPECT_TRUE(file().is_dirty());
  EXPECT_TRUE(project_.Find(other.path())->is_dirty());
  project_.Undo();
  EXPECT_FALSE(file().is_dirty());
  EXPECT_FALSE(project_.Find(other.path())->is_dirty());
}

TEST_F(OpenProjectTest, AChangeThatIsMalformedChangesNothing) {
  EXPECT_FALSE(
      project_.Do({"Break", {{path_, {{Replacement(0, 0, "<")}}, {}, {}}}}, {}, diagnostics_));
  EXPECT_TRUE(diagnostics_.has_errors());
  EXPECT_EQ(file().text, kRound);
  EXPECT_TRUE(project_.history().steps().empty());
}

TEST_F(OpenProjectTest, TypedTextMayBeMalformedAndIsKept) {
  project_.SetText(path_, "Type", "<root");
  EXPECT_FALSE(file().document);
  EXPECT_TRUE(file().problems.has_errors());
  ASSERT_TRUE(project_.Save(path_, diagnostics_));
  EXPECT_EQ(ReadFile(path_), "<root");
  project_.Undo();
  EXPECT_TRUE(file().document);
  EXPECT_EQ(file().text, kRound);
}

TEST_F(OpenProjectTest, SaveWritesTheTextAndUndoGoesOnBehindIt) {
  Delete("A");
  ASSERT_TRUE(project_.Save(path_, diagnostics_));
  EXPECT_FALSE(file().is_dirty());
  EXPECT_EQ(ReadFile(path_), file().text);
  project_.Undo();
  EXPECT_TRUE(file().is_dirty());
  ASSERT_TRUE(project_.Save(path_, diagnostics_));
  EXPECT_EQ(ReadFile(path_), kRound);
}

TEST_F(OpenProjectTest, SavingAnUnchangedFileDoesNotWriteIt) {
  const auto time = std::filesystem::last_write_time(path_);
  ASSERT_TRUE(project_.Save(path_, diagnostics_));
  EXPECT_EQ(std::filesystem::last_write_time(path_), time);
}

TEST_F(OpenProjectTest, ACleanFileFollowsTheDisk) {
  WriteFromOutside("<root/>\n");
  EXPECT_THAT(project_.LookAtDisk(), ElementsAre(path_));
  EXPECT_EQ(file().text, "<root/>\n");
  EXPECT_FALSE(file().is_dirty());
  EXPECT_TRUE(project_.LookAtDisk().empty());
  project_.Undo();
  EXPECT_EQ(file().text, kRound) << "it can be undone as any other step";
}

TEST_F(OpenProjectTest, ADirtyFileKeepsTheUsersText) {
  Delete("A");
  const std::string mine = file().text;
  WriteFromOutside("<root/>\n");
  EXPECT_THAT(project_.LookAtDisk(), ElementsAre(path_));
  EXPECT_EQ(file().text, mine);
  EXPECT_EQ(file().other, "<root/>\n");
  EXPECT_FALSE(project_.Save(path_, diagnostics_));
  EXPECT_EQ(ReadFile(path_), "<root/>\n");
  EXPECT_TRUE(project_.Save(path_, diagnostics_, true));
  EXPECT_EQ(ReadFile(path_), mine);
}

TEST_F(OpenProjectTest, SaveSeesAChangeThatNobodyLookedFor) {
  Delete("A");
  WriteFromOutside("<root/>\n");
  EXPECT_FALSE(project_.Save(path_, diagnostics_));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("somebody else"));
}

TEST_F(OpenProjectTest, TheUserChoosesBetweenTheTwo) {
  Delete("A");
  const std::string mine = file().text;
  WriteFromOutside("<root/>\n");
  project_.LookAtDisk();
  project_.TakeTheirs(path_);
  EXPECT_EQ(file().text, "<root/>\n");
  EXPECT_FALSE(file().is_dirty());
  project_.Undo();
  EXPECT_EQ(file().text, mine);
  WriteFromOutside("<other/>\n");
  project_.LookAtDisk();
  project_.KeepMine(path_);
  EXPECT_TRUE(project_.Save(path_, diagnostics_));
  EXPECT_EQ(ReadFile(path_), mine);
}

TEST_F(OpenProjectTest, ANewFileIsSavedUnderAName) {
  project_.Create("untitled.xml", "<root/>\n");
  EXPECT_TRUE(project_.Find("untitled.xml")->is_dirty());
  const std::string path = file_.folder() + "/new.xml";
  ASSERT_TRUE(project_.SaveAs("untitled.xml", path, diagnostics_));
  EXPECT_EQ(project_.Find("untitled.xml"), nullptr);
  EXPECT_FALSE(project_.Find(path)->is_dirty());
  EXPECT_EQ(ReadFile(path), "<root/>\n");
}

TEST_F(OpenProjectTest, HistoryFollowsAFileToItsNewName) {
  Delete("A");
  const std::string path = file_.folder() + "/new.xml";
  ASSERT_TRUE(project_.SaveAs(path_, path, diagnostics_));
  EXPECT_NE(project_.Undo(), nullptr);
  EXPECT_EQ(project_.Find(path)->text, kRound);
}

}  // namespace
}  // namespace coppice::editor
