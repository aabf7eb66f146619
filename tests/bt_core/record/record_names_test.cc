#include "bt_core/record/record_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;

TEST(NumberedName, PutsTheNumberBeforeTheExtension) {
  EXPECT_EQ(NumberedName("/a.b/run.coppice", 1), "/a.b/run.coppice");
  EXPECT_EQ(NumberedName("/a.b/run.coppice", 12), "/a.b/run.12.coppice");
  EXPECT_EQ(NumberedName("/a.b/run", 2), "/a.b/run.2");
}

TEST(FilesOfSeries, FindsThemInTheirOrderFromAnyOfThem) {
  const TemporaryFolder folder;
  for (const char* name : {"run.coppice", "run.2.coppice", "run.10.coppice", "run.9.coppice",
                           "run2.coppice", "run.02.coppice", "run.x.coppice", "run.2.txt",
                           "run.1.coppice", "run.99999999999999999999.coppice"}) {
    WriteFile(folder.Path(name), "");
  }
  for (const char* name : {"run.coppice", "run.10.coppice"}) {
    std::vector<std::string> names;
    for (const NumberedFile& file : FilesOfSeries(folder.Path(name))) {
      names.push_back(std::to_string(file.number) + " " + file.path);
    }
    EXPECT_THAT(
        names,
        ElementsAre("1 " + folder.Path("run.coppice"), "2 " + folder.Path("run.2.coppice"),
                    "9 " + folder.Path("run.9.coppice"), "10 " + folder.Path("run.10.coppice")));
  }
}

TEST(FilesOfSeries, FindsNothingInAFolderThatThereIsNot) {
  EXPECT_TRUE(FilesOfSeries("/nowhere/run.coppice").empty());
}

}  // namespace
}  // namespace coppice
