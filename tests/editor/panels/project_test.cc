#include <gtest/gtest.h>

#include "tests/editor/driver.h"
#include "tests/support/folders.h"

namespace coppice::editor {
namespace {

TEST(Project, ListsFilesWithTheirTreesAndShowsTheOneThatIsClicked) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  EXPECT_TRUE(driver.Has("project/small.xml"));
  ASSERT_TRUE(driver.Click("project/small.xml/Walk"));
  EXPECT_TRUE(driver.Has("canvas/Walk/1"));
  EXPECT_EQ(driver.Selected(), "");
}

TEST(Project, ListsIncludedFiles) {
  Driver driver;
  driver.editor.Open(SourceFolder() + "/trees/application/patrol.xml");
  driver.Frames();
  EXPECT_TRUE(driver.Has("project/patrol.xml/Application"));
  EXPECT_TRUE(driver.Has("project/patrol_round.xml/PatrolRound"));
}

TEST(Project, KeepsAFileThatCannotBeRead) {
  const TemporaryFile file("broken.xml", "<root");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  EXPECT_TRUE(driver.Has("project/broken.xml"));
}

}  // namespace
}  // namespace coppice::editor
