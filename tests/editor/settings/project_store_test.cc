#include "editor/settings/project_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ProjectStoreTest : public testing::Test {
 protected:
  static ProjectSettings Settings(const std::string& project) {
    ProjectSettings settings;
    settings.folder = project;
    settings.tiles.outline = false;
    return settings;
  }
  // What is said of a file with that text.
  std::string Said(const std::string& text) {
    EXPECT_TRUE(store_.Keep(Settings("/p")));
    WriteFile(store_.FileOf("/p"), text);
    Diagnostics diagnostics;
    EXPECT_FALSE(store_.Load("/p", diagnostics)) << text;
    return diagnostics.ToString();
  }

  const TemporaryFolder folder_;
  const ProjectStore store_{folder_.Path("state/projects")};
};

TEST_F(ProjectStoreTest, FindsWhatItKept) {
  ASSERT_TRUE(store_.Keep(Settings("/home/me/robot")));
  Diagnostics diagnostics;
  const auto found = store_.Load("/home/me/robot", diagnostics);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->tiles.outline);
  EXPECT_FALSE(store_.Load("/home/me/other", diagnostics));
  EXPECT_EQ(diagnostics.ToString(), "") << "nothing is wrong with a project that is new";
}

TEST_F(ProjectStoreTest, ADamagedFileIsSaidAndNothingOfItHolds) {
  EXPECT_THAT(Said("{\"folder\": \"/p\", \"tiles\": {\"xml\": 3}}"), HasSubstr("\"xml\" is not"));
  EXPECT_THAT(Said("{\"folder\": \"/p\", \"til"), HasSubstr("error"));
  EXPECT_THAT(Said(std::string(100000, '[')), HasSubstr("error"));
  EXPECT_THAT(Said(std::string(ProjectStore::kLongest + 1, ' ')), HasSubstr("error"));
  EXPECT_THAT(Said(""), HasSubstr("error"));
}

TEST_F(ProjectStoreTest, AFileOfAnotherProjectDoesNotHold) {
  EXPECT_EQ(Said(WriteProject(Settings("/q"))), "");
}

TEST_F(ProjectStoreTest, APipeInThePlaceOfTheFileIsNotWaitedFor) {
  ASSERT_TRUE(store_.Keep(Settings("/p")));
  fs::remove(store_.FileOf("/p"));
  ASSERT_EQ(mkfifo(store_.FileOf("/p").c_str(), 0600), 0);
  Diagnostics diagnostics;
  EXPECT_FALSE(store_.Load("/p", diagnostics));
}

TEST_F(ProjectStoreTest, ForgetsWhatWasNotUsedForLongest) {
  ASSERT_TRUE(store_.Keep(Settings("/used")));
  ASSERT_TRUE(store_.Keep(Settings("/unused")));
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1000);
  for (const char* project : {"/used", "/unused"}) {
    fs::last_write_time(store_.FileOf(project), long_ago);
  }
  Diagnostics diagnostics;
  ASSERT_TRUE(store_.Load("/used", diagnostics));
  for (std::size_t i = 1; i < ProjectStore::kMostProjects; ++i) {
    ASSERT_TRUE(store_.Keep(Settings("/p" + std::to_string(i))));
  }
  EXPECT_TRUE(store_.Load("/used", diagnostics));
  EXPECT_FALSE(store_.Load("/unused", diagnostics));
}

TEST(ProjectStore, WithoutAFolderKeepsNothing) {
  ProjectSettings settings;
  settings.folder = "/p";
  EXPECT_FALSE(ProjectStore("").Keep(settings));
}

}  // namespace
}  // namespace coppice::editor
