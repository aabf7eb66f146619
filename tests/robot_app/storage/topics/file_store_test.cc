#include "robot_app/storage/topics/file_store.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace coppice::robot::storage {
namespace {

constexpr std::int64_t kMorning = 1764059400'123456789;  // 2025-11-25 08:30 UTC
constexpr std::int64_t kDay = 24 * 3600 * 1'000'000'000LL;

TEST(FileStore, KeepsFilesByDay) {
  const TemporaryFolder folder;
  FileStore store(folder.path(), 1000);
  const std::string name = store.Keep("abc", kMorning);
  EXPECT_EQ(name, "2025-11-25/083000.123456-1.bin");
  EXPECT_EQ(ReadKeptFile(folder.path(), name), "abc");
}

TEST(FileStore, GivesTheOldestUpWhenTheyTakeTooMuchRoom) {
  const TemporaryFolder folder;
  FileStore store(folder.path(), 10);
  const std::string first = store.Keep("12345", kMorning);
  const std::string second = store.Keep("12345", kMorning + kDay);
  const std::string third = store.Keep("12345", kMorning + 2 * kDay);
  EXPECT_EQ(ReadKeptFile(folder.path(), first), std::nullopt);
  EXPECT_TRUE(ReadKeptFile(folder.path(), second));
  EXPECT_TRUE(ReadKeptFile(folder.path(), third));
  EXPECT_EQ(store.bytes(), 10u);
  EXPECT_EQ(store.Keep("12345678901", kMorning), "");
}

TEST(FileStore, TakesOverWhatIsThere) {
  const TemporaryFolder folder;
  const std::string first = FileStore(folder.path(), 10).Keep("12345", kMorning);
  FileStore store(folder.path(), 10);
  EXPECT_EQ(store.bytes(), 5u);
  store.Keep("123456", kMorning + kDay);
  EXPECT_EQ(ReadKeptFile(folder.path(), first), std::nullopt);
}

TEST(ReadKeptFile, NeverLeavesTheFolder) {
  const TemporaryFolder folder;
  WriteFile(folder.Path("secret"), "x");
  EXPECT_EQ(ReadKeptFile(folder.Path("files"), "../secret"), std::nullopt);
  EXPECT_EQ(ReadKeptFile(folder.path(), folder.Path("secret")), std::nullopt);
  EXPECT_EQ(ReadKeptFile("", "secret"), std::nullopt);
}

}  // namespace
}  // namespace coppice::robot::storage
