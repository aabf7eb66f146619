#include "editor/files/history_store.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class HistoryStoreTest : public testing::Test {
 protected:
  const EditedFile& Open(OpenProject& project, const std::string& path) {
    return *project.Open(path, diagnostics_);
  }
  // One file in two versions, saved, with the history of it in the folder.
  void EditAndSave(const std::string& path) {
    OpenProject project;
    Open(project, path);
    HistoryStore store(folder_);
    store.Restore(project);
    project.SetText(path, "Type", R"(<root a="1"/>)");
    project.SetText(path, "Type more", R"(<root a="12"/>)");
    EXPECT_TRUE(project.Save(path, diagnostics_));
    store.Update(project);
  }

  TemporaryFile file_{"a.xml", "<root/>"};
  TemporaryFile other_{"b.xml", "<root/>"};
  std::string folder_ = file_.folder() + "/backup";
  Diagnostics diagnostics_;
};

TEST_F(HistoryStoreTest, UndoGoesOnAfterARestart) {
  EditAndSave(file_.path());
  OpenProject project;
  const EditedFile& file = Open(project, file_.path());
  HistoryStore store(folder_);
  EXPECT_EQ(store.Restore(project), 2U);
  ASSERT_NE(project.Undo(), nullptr);
  EXPECT_EQ(file.text, R"(<root a="1"/>)");
  EXPECT_EQ(project.Undo()->name, "Type");
  EXPECT_EQ(file.text, "<root/>");
  EXPECT_EQ(project.Undo(), nullptr);
  store.Update(project);

  OpenProject third;
  Open(third, file_.path());
  EXPECT_EQ(HistoryStore(folder_).Restore(third), 2U) << "the file is as the first editor left it";
}

TEST_F(HistoryStoreTest, WhatWasUndoneCanBeDoneAgainAfterARestart) {
  {
    OpenProject project;
    Open(project, file_.path());
    project.SetText(file_.path(), "Type", R"(<root a="1"/>)");
    project.Undo();
    HistoryStore(folder_).Update(project);
  }
  OpenProject project;
  const EditedFile& file = Open(project, file_.path());
  HistoryStore(folder_).Restore(project);
  EXPECT_EQ(project.history().undo(), nullptr);
  ASSERT_NE(project.Redo(), nullptr);
  EXPECT_EQ(file.text, R"(<root a="1"/>)");
}

TEST_F(HistoryStoreTest, AFileThatSomebodyElseHasChangedHasNoHistory) {
  EditAndSave(file_.path());
  file_.Write(R"(<root b="2"/>)");
  OpenProject project;
  Open(project, file_.path());
  EXPECT_EQ(HistoryStore(folder_).Restore(project), 0U);
}

TEST_F(HistoryStoreTest, AFileThatIsOpenedLaterBringsItsHistoryAlong) {
  EditAndSave(other_.path());
  EditAndSave(file_.path());
  OpenProject project;
  Open(project, file_.path());
  HistoryStore store(folder_);
  EXPECT_EQ(store.Restore(project), 2U);
  project.SetText(file_.path(), "Now", R"(<root now="1"/>)");
  Open(project, other_.path());
  EXPECT_EQ(store.Restore(project), 2U);
  EXPECT_EQ(store.Restore(project), 0U) << "once is enough";
  EXPECT_EQ(project.history().undo()->name, "Now");
  while (project.Undo()) continue;
  EXPECT_EQ(project.Find(file_.path())->text, "<root/>");
  EXPECT_EQ(project.Find(other_.path())->text, "<root/>");
}

TEST_F(HistoryStoreTest, AStepOfTwoFilesNeedsBoth) {
  {
    OpenProject project;
    Open(project, file_.path());
    Open(project, other_.path());
    project.SetText(file_.path(), "Before", R"(<root a="1"/>)");
    NamedChange both;
    both.name = "Rename";
    both.files = {{file_.path(), {{{6, 0, R"(b="2" )"}}}, {}, {}},
                  {other_.path(), {{{5, 0, R"( b="2")"}}}, {}, {}}};
    ASSERT_TRUE(project.Do(both, {}, diagnostics_)) << diagnostics_.ToString();
    project.SetText(file_.path(), "After", R"(<root c="3"/>)");
    ASSERT_TRUE(project.Save(file_.path(), diagnostics_));
    ASSERT_TRUE(project.Save(other_.path(), diagnostics_));
    HistoryStore(folder_).Update(project);
  }
  OpenProject one;
  Open(one, file_.path());
  EXPECT_EQ(HistoryStore(folder_).Restore(one), 1U) << "only what came after it";
  OpenProject two;
  Open(two, file_.path());
  Open(two, other_.path());
  EXPECT_EQ(HistoryStore(folder_).Restore(two), 3U);
  while (two.Undo()) continue;
  EXPECT_EQ(two.Find(other_.path())->text, "<root/>");
}

TEST_F(HistoryStoreTest, UnsavedWorkComesBackWithItsHistory) {
  {
    OpenProject project;
    Open(project, file_.path());
    project.SetText(file_.path(), "Type", R"(<root a="1"/>)");
    HistoryStore(folder_).Update(project);
  }
  OpenProject project;
  const EditedFile& file = Open(project, file_.path());
  HistoryStore store(folder_);
  EXPECT_EQ(store.Restore(project), 0U);
  EXPECT_FALSE(store.Resume(project, file_.path(), R"(<root other=""/>)"));
  EXPECT_EQ(file.text, "<root/>");
  EXPECT_TRUE(store.Resume(project, file_.path(), R"(<root a="1"/>)"));
  EXPECT_TRUE(file.is_dirty());
  ASSERT_NE(project.Undo(), nullptr);
  EXPECT_EQ(file.text, "<root/>");
}

TEST_F(HistoryStoreTest, OldHistoriesAreRemoved) {
  for (std::size_t i = 0; i < HistoryStore::kMostFiles + 3; ++i) EditAndSave(file_.path());
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    files += entry.is_regular_file() ? 1 : 0;
  }
  EXPECT_EQ(files, HistoryStore::kMostFiles);
}

TEST_F(HistoryStoreTest, DamagedFilesAreNoHistory) {
  std::filesystem::create_directories(folder_);
  std::ofstream(folder_ + "/history-1") << "coppice undo history 1\nnonsense";
  OpenProject project;
  Open(project, file_.path());
  EXPECT_EQ(HistoryStore(folder_).Restore(project), 0U);
}

TEST_F(HistoryStoreTest, AStoryOfARestart) {
  file_.Write(kSmallFile);
  EditorOptions options;
  options.backup_folder = folder_;
  {
    Driver driver(options);
    driver.editor.Open(file_.path());
    driver.Frames();
    driver.view().Select(driver.view().scene()->FindPath("1.3"));
    driver.Press('D');
    driver.Press('S', kCtrl);
    driver.Frames();
  }
  Driver driver(options);
  driver.editor.Open(file_.path());
  driver.Frames();
  const EditedFile& file = *driver.editor.state().workspace.project().Find(file_.path());
  EXPECT_NE(file.text, kSmallFile);
  driver.Press('Z', kCtrl);
  EXPECT_EQ(file.text, kSmallFile);
  EXPECT_EQ(driver.Selected(), "1.3");
}

}  // namespace
}  // namespace coppice::editor
