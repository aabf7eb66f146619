#include "bt_core/record/record_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <stdexcept>

#include "tests/support/full_disk.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;

std::string WhyNot(const std::string& path) {
  try {
    const RecordFile file(path);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(RecordFile, AppendsAndTakesWhatIsWritten) {
  const TemporaryFolder folder;
  RecordFile file(folder.Path("a"));
  for (const char byte : {'1', '2'}) {
    Bytes bytes(3, static_cast<std::uint8_t>(byte));
    EXPECT_EQ(file.Write(bytes).problem(), "");
    EXPECT_TRUE(bytes.empty());
  }
  EXPECT_EQ(file.Sync().problem(), "");
  EXPECT_EQ(ReadFile(folder.Path("a")), "111222");
}

TEST(RecordFile, OverwritesNothing) {
  const TemporaryFolder folder;
  WriteFile(folder.Path("a"), "an older record");
  EXPECT_THAT(WhyNot(folder.Path("a")), HasSubstr("there is a file already"));
  EXPECT_EQ(ReadFile(folder.Path("a")), "an older record");
  WriteFile(folder.Path("empty"), "");
  EXPECT_EQ(WhyNot(folder.Path("empty")), "");
}

TEST(RecordFile, SaysWhyItCannotBeMade) {
  EXPECT_THAT(WhyNot("/nowhere/a"), HasSubstr("/nowhere/a: cannot make this record: No such file"));
}

TEST(RecordFile, NoticesThatItWasDeleted) {
  const TemporaryFolder folder;
  RecordFile file(folder.Path("a"));
  EXPECT_EQ(file.Sync().problem(), "");
  std::filesystem::remove(folder.Path("a"));
  EXPECT_THAT(file.Sync().problem(), HasSubstr("deleted this record"));
}

TEST(RecordFile, IsNoFolderAndNoDevice) {
  const TemporaryFolder folder;
  for (const std::string& path : {folder.path(), std::string("/dev/full")}) {
    EXPECT_THAT(WhyNot(path), HasSubstr("a record is a file"));
  }
}

TEST(RecordFile, WaitsForNoReaderOfAPipe) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo(folder.Path("pipe").c_str(), 0600), 0);
  EXPECT_THAT(WhyNot(folder.Path("pipe")), HasSubstr("pipe: cannot make this record"));
}

TEST(RecordFile, SaysThatTheDiskIsFullAndKeepsTheRest) {
  const TemporaryFolder folder;
  RecordFile file(folder.Path("a"));
  const FullDisk disk(0);
  Bytes bytes(3, 'x');
  EXPECT_THAT(file.Write(bytes).problem(), HasSubstr("a: cannot write: File too large"));
  EXPECT_EQ(bytes.size(), 3u);
}

}  // namespace
}  // namespace coppice
