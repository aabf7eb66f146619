#include "editor/files/backup.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class BackupTest : public testing::Test {
 protected:
  void Edit(OpenProject& project, const std::string& text) {
    project.SetText(file_.path(), "Type", text);
  }
  const EditedFile& Open(OpenProject& project) {
    Diagnostics diagnostics;
    return *project.Open(file_.path(), diagnostics);
  }

  TemporaryFile file_{"small.xml", "<root/>"};
  std::string folder_ = file_.folder() + "/backup";
};

TEST_F(BackupTest, AnEditorThatWasKilledLeavesItsWork) {
  {
    OpenProject project;
    Open(project);
    Edit(project, R"(<root a="1"/>)");
    Backup(folder_).Update(project);
  }
  OpenProject project;
  EXPECT_EQ(Backup(folder_).Find(Open(project)), R"(<root a="1"/>)");
}

TEST_F(BackupTest, WhatWasSavedIsForgotten) {
  OpenProject project;
  Open(project);
  Backup backup(folder_);
  Edit(project, R"(<root a="1"/>)");
  backup.Update(project);
  Diagnostics diagnostics;
  ASSERT_TRUE(project.Save(file_.path(), diagnostics));
  backup.Update(project);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
  EXPECT_EQ(backup.Find(Open(project)), std::nullopt);
}

TEST_F(BackupTest, WithoutAFolderNothingIsKept) {
  OpenProject project;
  Open(project);
  Edit(project, R"(<root a="1"/>)");
  Backup backup("");
  backup.Update(project);
  EXPECT_EQ(backup.Find(Open(project)), std::nullopt);
}

TEST_F(BackupTest, AStoryOfACrash) {
  EditorOptions options;
  options.backup_folder = folder_;
  file_.Write(kSmallFile);
  {
    Driver driver(options);
    driver.editor.Open(file_.path());
    driver.Frames();
    driver.view().Select(driver.view().scene()->FindPath("1.3"));
    driver.Press('D');
    driver.Frames(300);  // more than the seconds between two backups
  }                      // gone without saving
  Driver driver(options);
  driver.editor.Open(file_.path());
  driver.Frames();
  EXPECT_TRUE(driver.Click("banner/restore")) << "a bar above the tree offers it";
  const EditedFile& file = *driver.editor.state().workspace.project().Find(file_.path());
  EXPECT_NE(file.text.find(R"(<AlwaysSuccess _skipIf="true"/>)"), std::string::npos);
  driver.Press('Z', kCtrl);
  EXPECT_EQ(file.text, kSmallFile);
}

}  // namespace
}  // namespace coppice::editor
