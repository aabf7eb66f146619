#include "bt_core/record/record_series.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "bt_core/frames/frame.h"
#include "tests/support/full_disk.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;

void Append(RecordSeries& series, const std::string& text) {
  Bytes bytes(text.begin(), text.end());
  EXPECT_EQ(series.Write(bytes).problem(), "");
}

std::string Content(const TemporaryFolder& folder, const std::string& name) {
  const std::string content = ReadFile(folder.Path(name));
  return content.size() < kPreambleSize ? "(none)" : content.substr(kPreambleSize);
}

TEST(RecordSeries, GoesOnInFilesWithNumbers) {
  const TemporaryFolder folder;
  RecordSeries series(folder.Path("run.coppice"), 0);
  Append(series, "one");
  EXPECT_EQ(series.Next().problem(), "");
  Append(series, "two");
  EXPECT_EQ(series.Next().problem(), "");
  Append(series, "three");
  EXPECT_EQ(Content(folder, "run.coppice"), "one");
  EXPECT_EQ(Content(folder, "run.2.coppice"), "two");
  EXPECT_EQ(Content(folder, "run.3.coppice"), "three");
}

TEST(RecordSeries, KeepsTheNewestFiles) {
  const TemporaryFolder folder;
  RecordSeries series(folder.Path("run.coppice"), 2);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(series.Next().problem(), "");
  EXPECT_FALSE(std::filesystem::exists(folder.Path("run.coppice")));
  EXPECT_FALSE(std::filesystem::exists(folder.Path("run.3.coppice")));
  EXPECT_TRUE(std::filesystem::exists(folder.Path("run.4.coppice")));
  EXPECT_TRUE(std::filesystem::exists(folder.Path("run.5.coppice")));
}

TEST(RecordSeries, LeavesOutNamesThatAreTaken) {
  const TemporaryFolder folder;
  WriteFile(folder.Path("run.2.coppice"), "precious");
  RecordSeries series(folder.Path("run.coppice"), 1);
  EXPECT_EQ(series.Next().problem(), "");
  Append(series, "two");
  EXPECT_EQ(ReadFile(folder.Path("run.2.coppice")), "precious");
  EXPECT_EQ(Content(folder, "run.3.coppice"), "two");
}

TEST(RecordSeries, StaysInTheOldFileIfNoOtherCanBeMade) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.Path("a"));
  RecordSeries series(folder.Path("a/run.coppice"), 0);
  std::filesystem::rename(folder.Path("a"), folder.Path("b"));
  EXPECT_THAT(series.Next().problem(), HasSubstr("run.2.coppice: cannot make this record"));
  Append(series, "more");
  EXPECT_EQ(Content(folder, "b/run.coppice"), "more");
}

TEST(RecordSeries, ThrowsIfTheFirstFileCannotBeWritten) {
  EXPECT_THROW(RecordSeries("/nowhere/run.coppice", 0), std::runtime_error);
  const TemporaryFolder folder;
  const FullDisk disk(0);
  EXPECT_THROW(RecordSeries(folder.Path("run.coppice"), 0), std::runtime_error);
}

}  // namespace
}  // namespace coppice
