#include "bt_core/model/write_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace coppice {
namespace {

namespace fs = std::filesystem;

class WriteFileTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("coppice_write_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  std::string Read(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  std::size_t CountFiles() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
  Diagnostics diagnostics_;
};

TEST_F(WriteFileTest, WritesEveryByteAndLeavesNoOtherFile) {
  const std::string text("\xEF\xBB\xBF<a>\r\n\0\xFF</a>", 13);
  EXPECT_TRUE(WriteFile(Path("t.xml"), text, diagnostics_)) << diagnostics_.ToString();
  EXPECT_EQ(Read("t.xml"), text);
  EXPECT_TRUE(WriteFile(Path("t.xml"), "", diagnostics_));
  EXPECT_EQ(Read("t.xml"), "");
  EXPECT_EQ(CountFiles(), 1U);
}

TEST_F(WriteFileTest, TakesAwayWhatAKilledProgramLeftAnHourAgo) {
  const auto leave = [this](const std::string& name, std::chrono::minutes age) {
    std::ofstream(Path(name)) << "half a fi";
    fs::last_write_time(Path(name), fs::file_time_type::clock::now() - age);
  };
  const std::string abandoned = DraftName("map.pgm");
  leave(abandoned, std::chrono::minutes(61));
  leave(DraftName("map.pgm"), std::chrono::minutes(59));       // somebody may still write it
  leave("map.pgm.saving-tomorrow", std::chrono::minutes(61));  // of a person
  leave("map.pgm.abcd1234", std::chrono::minutes(61));
  EXPECT_TRUE(WriteFile(Path("map.yaml"), "image: map.pgm", diagnostics_));
  EXPECT_FALSE(fs::exists(Path(abandoned)));
  EXPECT_EQ(CountFiles(), 4U);
}

// There may be a hundred thousand files.
TEST_F(WriteFileTest, DoesNotLookThroughTheFolderAgainAtOnce) {
  EXPECT_TRUE(WriteFile(Path("1.bin"), "1", diagnostics_));
  const std::string abandoned = Path(DraftName("2.bin"));
  std::ofstream(abandoned) << "half a fi";
  fs::last_write_time(abandoned, fs::file_time_type::clock::now() - std::chrono::hours(2));
  EXPECT_TRUE(WriteFile(Path("3.bin"), "3", diagnostics_));
  EXPECT_TRUE(fs::exists(abandoned));
}

TEST_F(WriteFileTest, LeavesPipesAndDevicesWhatTheyAre) {
  ASSERT_EQ(mkfifo(Path("pipe").c_str(), 0600), 0);
  fs::create_symlink(Path("pipe"), Path("link"));
  for (const char* name : {"pipe", "link"}) {
    EXPECT_FALSE(WriteFile(Path(name), "text", diagnostics_));
    EXPECT_TRUE(fs::is_fifo(Path(name)));
  }
  EXPECT_NE(diagnostics_.ToString().find("a device or a pipe"), std::string::npos);
  EXPECT_EQ(CountFiles(), 2U);
}

TEST_F(WriteFileTest, KeepsThePermissions) {
  std::ofstream(Path("t.xml")) << "old";
  chmod(Path("t.xml").c_str(), 0640);
  ASSERT_TRUE(WriteFile(Path("t.xml"), "new", diagnostics_));
  EXPECT_EQ(fs::status(Path("t.xml")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST_F(WriteFileTest, ANewFileGetsTheUsualPermissions) {
  std::ofstream(Path("usual.xml")) << "";
  ASSERT_TRUE(WriteFile(Path("t.xml"), "new", diagnostics_));
  EXPECT_EQ(fs::status(Path("t.xml")).permissions(), fs::status(Path("usual.xml")).permissions());
}

TEST_F(WriteFileTest, WhatIsForItsOwnerAloneIsAlsoWhereOthersCouldReadIt) {
  std::ofstream(Path("t.xml")) << "old";
  chmod(Path("t.xml").c_str(), 0644);
  for (const char* name : {"t.xml", "new.xml"}) {
    ASSERT_TRUE(WriteFile(Path(name), "secret", diagnostics_, FileReaders::kOwnerOnly));
    EXPECT_EQ(fs::status(Path(name)).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  }
}

TEST_F(WriteFileTest, ALinkStaysALink) {
  std::ofstream(Path("real.xml")) << "old";
  fs::create_symlink("real.xml", folder_ / "link.xml");
  ASSERT_TRUE(WriteFile(Path("link.xml"), "new", diagnostics_));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.xml"));
  EXPECT_EQ(Read("real.xml"), "new");
}

TEST_F(WriteFileTest, AnOpenOldFileIsNotTouched) {
  std::ofstream(Path("t.xml")) << "old";
  std::ifstream old(Path("t.xml"));
  ASSERT_TRUE(WriteFile(Path("t.xml"), "new text", diagnostics_));
  std::string word;
  old >> word;
  EXPECT_EQ(word, "old") << "the new text is another file that took the name";
}

TEST_F(WriteFileTest, AFailureLeavesTheOldFileAndSaysWhy) {
  EXPECT_FALSE(WriteFile(Path("no/t.xml"), "x", diagnostics_));
  fs::create_directories(folder_ / "folder" / "full");
  EXPECT_FALSE(WriteFile(Path("folder"), "x", diagnostics_));
  EXPECT_TRUE(fs::is_directory(folder_ / "folder"));
  EXPECT_EQ(CountFiles(), 1U) << "no temporary file is left";
  ASSERT_EQ(diagnostics_.all().size(), 2U);
  EXPECT_EQ(ToString(diagnostics_.all()[0]), Path("no/t.xml") +
                                                 ": error: cannot write this file "
                                                 "(No such file or directory)");
}

}  // namespace
}  // namespace coppice
