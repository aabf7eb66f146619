#include "editor/files/unsaved_work.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

constexpr char kChanged[] = R"(<root a="1"/>)";

class UnsavedWorkTest : public testing::Test {
 protected:
  const EditedFile& Open(OpenProject& project) const {
    Diagnostics diagnostics;
    return *project.Open(file_.path(), diagnostics);
  }
  void Edit(OpenProject& project, const std::string& text = kChanged) const {
    Open(project);
    project.SetText(file_.path(), "Type", text);
  }
  // As an editor that is killed.
  void LeaveBehind(const std::string& text = kChanged) const {
    OpenProject project;
    Edit(project, text);
    UnsavedWork(folder_).Keep(project);
  }
  std::vector<UnsavedCopy> Left() const {
    UnsavedWork work(folder_);
    work.Look(OpenProject());
    return work.left();
  }

  TemporaryFile file_{"small.xml", "<root/>"};
  std::string folder_ = file_.folder() + "/work";
};

TEST_F(UnsavedWorkTest, AnEditorThatWasKilledLeavesItsWork) {
  LeaveBehind();
  const std::vector<UnsavedCopy> left = Left();
  ASSERT_THAT(left, SizeIs(1));
  EXPECT_EQ(left[0].path, file_.path());
  EXPECT_FALSE(left[0].is_new);
  EXPECT_EQ(UnsavedWork::TextOf(left[0]), kChanged);
}

TEST_F(UnsavedWorkTest, WhatWasSavedIsForgotten) {
  OpenProject project;
  Edit(project);
  UnsavedWork work(folder_);
  work.Keep(project);
  Diagnostics diagnostics;
  ASSERT_TRUE(project.Save(file_.path(), diagnostics));
  work.Keep(project);
  EXPECT_THAT(Left(), SizeIs(0));
}

TEST_F(UnsavedWorkTest, WhatWasSavedUnderAnotherNameIsForgotten) {
  OpenProject project;
  Edit(project);
  UnsavedWork work(folder_);
  work.Keep(project);
  Diagnostics diagnostics;
  ASSERT_TRUE(project.SaveAs(file_.path(), file_.folder() + "/other.xml", diagnostics));
  work.Keep(project);
  EXPECT_TRUE(std::filesystem::exists(folder_));
  EXPECT_THAT(Left(), SizeIs(0));
}

TEST_F(UnsavedWorkTest, NobodyOverwritesWhatAnotherEditorLeft) {
  LeaveBehind("<root a='1'/>");
  LeaveBehind("<root a='2'/>");
  std::set<std::string> texts;
  for (const UnsavedCopy& copy : Left()) texts.insert(*UnsavedWork::TextOf(copy));
  EXPECT_EQ(texts, (std::set<std::string>{"<root a='1'/>", "<root a='2'/>"}));
}

TEST_F(UnsavedWorkTest, AnEditorThatLivesHasNotEnded) {
  OpenProject project;
  Edit(project);
  UnsavedWork alive(folder_);
  alive.Keep(project);
  UnsavedWork other(folder_);
  other.Look(project);
  EXPECT_THAT(other.left(), SizeIs(0));
  ASSERT_THAT(other.elsewhere(), SizeIs(1));
  EXPECT_EQ(other.elsewhere()[0].editor, getpid());
  alive.Look(project);
  EXPECT_THAT(alive.elsewhere(), SizeIs(0)) << "its own";
}

TEST_F(UnsavedWorkTest, ANewFileIsKeptOnceItWasTouched) {
  OpenProject project;
  project.Create("untitled.xml", "<root/>");
  UnsavedWork(folder_).Keep(project);
  EXPECT_THAT(Left(), SizeIs(0));
  project.SetText("untitled.xml", "Type", kChanged);
  UnsavedWork(folder_).Keep(project);
  ASSERT_THAT(Left(), SizeIs(1));
  EXPECT_TRUE(Left()[0].is_new);
}

TEST_F(UnsavedWorkTest, AFileThatIsGoneIsKept) {
  OpenProject project;
  Open(project);
  std::filesystem::remove(file_.path());
  project.LookAtDisk();
  UnsavedWork(folder_).Keep(project);
  ASSERT_THAT(Left(), SizeIs(1));
  EXPECT_EQ(UnsavedWork::TextOf(Left()[0]), "<root/>");
}

TEST_F(UnsavedWorkTest, ACopyOfWhatIsOnTheDiskAnywayGoes) {
  LeaveBehind();
  file_.Write(kChanged);
  OpenProject project;
  Open(project);
  UnsavedWork work(folder_);
  work.Look(project);
  EXPECT_THAT(work.left(), SizeIs(0));
  EXPECT_TRUE(std::filesystem::is_empty(folder_)) << "its lock too";
}

TEST_F(UnsavedWorkTest, ForgetsOneCopy) {
  LeaveBehind("<root a='1'/>");
  LeaveBehind("<root a='2'/>");
  UnsavedWork work(folder_);
  work.Look(OpenProject());
  work.Forget(work.left().front());
  EXPECT_THAT(work.left(), SizeIs(1));
  EXPECT_THAT(Left(), SizeIs(1));
}

TEST_F(UnsavedWorkTest, SaysWhenNothingCanBeKeptAndKeepsItLater) {
  WriteFile(folder_, "a file where the folder should be");
  OpenProject project;
  Edit(project);
  UnsavedWork work(folder_);
  work.Keep(project);
  EXPECT_THAT(work.trouble(), HasSubstr("Not a directory"));
  std::filesystem::remove(folder_);
  work.Keep(project);
  EXPECT_EQ(work.trouble(), "");
  UnsavedWork other(folder_);
  other.Look(project);
  EXPECT_THAT(other.elsewhere(), SizeIs(1));
}

TEST_F(UnsavedWorkTest, IsWrittenAgainWhenSomebodyRemovesIt) {
  OpenProject project;
  Edit(project);
  UnsavedWork work(folder_);
  work.Keep(project);
  std::filesystem::remove_all(folder_);
  work.Keep(project);
  UnsavedWork other(folder_);
  other.Look(project);
  EXPECT_THAT(other.elsewhere(), SizeIs(1));
}

TEST_F(UnsavedWorkTest, WithoutAFolderNothingIsKept) {
  OpenProject project;
  Edit(project);
  UnsavedWork work;
  work.Keep(project);
  work.Look(project);
  EXPECT_EQ(work.trouble(), "");
}

TEST_F(UnsavedWorkTest, WhatIsNoCopyIsPassedOver) {
  LeaveBehind();
  WriteFile(folder_ + "/1-1.1.unsaved", "");
  WriteFile(folder_ + "/1-2.1.unsaved", "nonsense\n\n");
  EXPECT_THAT(Left(), SizeIs(1));
}

}  // namespace
}  // namespace coppice::editor
