#include "editor/files/path_check.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace coppice::editor {
namespace {

TEST(PathCheck, NoticesAFileThatComesWithinASecond) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.xml");
  PathCheck check;
  EXPECT_FALSE(check.IsThere(path, 5));
  std::ofstream(path) << "<root/>";
  EXPECT_FALSE(check.IsThere(path, 5.5)) << "the disk was asked again";
  EXPECT_TRUE(check.IsThere(path, 6));
}

}  // namespace
}  // namespace coppice::editor
