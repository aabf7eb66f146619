#include "editor/files/folder.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace coppice::editor {
namespace {

TEST(Folder, ListsFoldersBeforeFilesAndBothByName) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.Path("z"));
  WriteFile(folder.Path("b.xml"), "");
  WriteFile(folder.Path("a.xml"), "");
  const Folder read = ReadFolder(folder.path());
  ASSERT_EQ(read.entries.size(), 3U);
  EXPECT_EQ(read.entries[0].name, "z");
  EXPECT_TRUE(read.entries[0].is_folder);
  EXPECT_EQ(read.entries[1].name, "a.xml");
  EXPECT_EQ(read.entries[2].name, "b.xml");
}

TEST(Folder, SaysWhyItCannotBeRead) {
  EXPECT_EQ(ReadFolder("/nowhere/at/all").problem, "No such file or directory");
}

}  // namespace
}  // namespace coppice::editor
