#include "bt_core/base/read_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdio>
#include <fstream>

namespace coppice {
namespace {

using testing::HasSubstr;

std::string ProblemOf(const std::string& path, std::size_t longest = kLongestFile) {
  Diagnostics diagnostics;
  EXPECT_FALSE(ReadFile(path, diagnostics, longest));
  EXPECT_FALSE(ReadFile(path, longest));
  return diagnostics.ToString();
}

TEST(ReadFile, GivesAllBytes) {
  const std::string path = testing::TempDir() + "read_file_test";
  std::string bytes(200'000, 'x');
  bytes[7] = '\0';
  std::ofstream(path, std::ios::binary) << bytes;
  EXPECT_EQ(ReadFile(path), bytes);
  EXPECT_EQ(ReadFile(path, bytes.size()), bytes);
  EXPECT_THAT(ProblemOf(path, bytes.size() - 1), HasSubstr("is longer than 199999 bytes"));
  std::ofstream(path, std::ios::trunc).close();
  EXPECT_EQ(ReadFile(path), "");
}

TEST(ReadFile, SaysWhyItCannotBeRead) {
  EXPECT_EQ(ProblemOf("/nowhere/a"),
            "/nowhere/a: error: cannot be read: No such file or directory\n");
  EXPECT_EQ(ProblemOf("/tmp"), "/tmp: error: cannot be read: Is a directory\n");
}

TEST(ReadFile, DoesNotWaitForAPipeThatNobodyWrites) {
  const std::string path = testing::TempDir() + "read_file_test_pipe";
  std::remove(path.c_str());
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  EXPECT_EQ(ReadFile(path), "");
  std::remove(path.c_str());
}

TEST(ReadFile, DoesNotReadWithoutEnd) {
  EXPECT_THAT(ProblemOf("/dev/zero", 1 << 20), HasSubstr("is longer than 1048576 bytes"));
  EXPECT_THAT(ProblemOf("/dev/zero", std::size_t{1} << 40),
              HasSubstr("is longer than 67108864 bytes"));
}

}  // namespace
}  // namespace coppice
