#include "bt_core/record/file_window.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

TEST(FileWindow, ShowsEveryPlaceOfAFileThatIsLargerThanTheWindow) {
  const TemporaryFolder folder;
  std::mt19937 random(1);
  std::string content(3 << 20, '\0');
  for (char& c : content) c = static_cast<char>(random());
  WriteFile(folder.Path("a"), content);
  FileWindow file(folder.Path("a"));
  ASSERT_EQ(file.size(), content.size());
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t offset = random() % content.size();
    const std::uint64_t count = random() % 2 ? random() % 100 : random() % content.size();
    const std::uint8_t* bytes = file.View(offset, count);
    ASSERT_EQ(bytes != nullptr, offset + count <= content.size());
    if (!bytes) continue;
    EXPECT_EQ(std::string(bytes, bytes + count), content.substr(offset, count));
  }
}

TEST(FileWindow, ShowsNothingBehindTheEnd) {
  const TemporaryFolder folder;
  WriteFile(folder.Path("a"), "abc");
  FileWindow file(folder.Path("a"));
  EXPECT_EQ(file.View(1, 3), nullptr);
  EXPECT_EQ(file.View(4, 0), nullptr);
  EXPECT_EQ(file.View(UINT64_MAX, 2), nullptr);
  EXPECT_NE(file.View(0, 3), nullptr);
}

TEST(FileWindow, SaysWhyItCannotRead) {
  EXPECT_EQ(FileWindow("/nowhere").error(), "No such file or directory");
  EXPECT_EQ(FileWindow("/tmp").error(), "not a regular file");
}

}  // namespace
}  // namespace coppice
