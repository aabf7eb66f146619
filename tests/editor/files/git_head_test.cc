#include "editor/files/git_head.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class GitHeadTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!OutputOf({"git", "--version"})) GTEST_SKIP() << "no git here";
    ASSERT_TRUE(Git({"init", "-q"}));
  }
  bool Git(std::vector<std::string> words) {
    words.insert(words.begin(), {"git", "-C", file_.folder(), "-c", "user.name=A", "-c",
                                 "user.email=a@b", "-c", "commit.gpgsign=false"});
    return OutputOf(words).has_value();
  }
  bool Commit() { return Git({"add", "."}) && Git({"commit", "-q", "-m", "change"}); }

  std::shared_ptr<const std::string> Ask(GitHead& git, const std::string& path) {
    git.TextOf(path);
    git.Wait();
    return git.TextOf(path);
  }

  TemporaryFile file_{"a b.xml", "<root/>\n"};
};

TEST_F(GitHeadTest, GivesTheTextOfTheLastCommit) {
  ASSERT_TRUE(Commit());
  file_.Write("<root changed=\"1\"/>\n");
  GitHead git;
  const auto text = Ask(git, file_.path());
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "<root/>\n");
}

TEST_F(GitHeadTest, NoticesACommit) {
  ASSERT_TRUE(Commit());
  GitHead git;
  Ask(git, file_.path());
  file_.Write("<root changed=\"1\"/>\n");
  ASSERT_TRUE(Commit());
  // The clock of the file system may be coarse.
  const auto log = file_.folder() + "/.git/logs/HEAD";
  std::filesystem::last_write_time(log,
                                   std::filesystem::last_write_time(log) + std::chrono::seconds(1));
  git.Look();
  git.Wait();
  EXPECT_EQ(*git.TextOf(file_.path()), "<root changed=\"1\"/>\n");
}

TEST_F(GitHeadTest, KnowsNothingOfAFileThatWasNeverCommitted) {
  GitHead git;
  EXPECT_EQ(Ask(git, file_.path()), nullptr);
  EXPECT_EQ(Ask(git, "/nowhere/at/all.xml"), nullptr);
}

// As in an archive that somebody sends: git would fetch the text with a command that stands there.
TEST_F(GitHeadTest, RunsNothingThatTheFolderAsksFor) {
  ASSERT_TRUE(Commit());
  const std::string copy = file_.folder() + "/copy";
  ASSERT_TRUE(Git({"config", "uploadpack.allowFilter", "true"}));
  ASSERT_TRUE(OutputOf({"git", "clone", "-q", "--filter=blob:none", "--no-checkout",
                        "file://" + file_.folder(), copy}));
  const std::string ran = file_.folder() + "/ran";
  ASSERT_TRUE(OutputOf({"git", "-C", copy, "config", "remote.origin.uploadpack",
                        "touch '" + ran + "'; git-upload-pack"}));
  GitHead git;
  EXPECT_EQ(Ask(git, copy + "/a b.xml"), nullptr);
  EXPECT_FALSE(std::filesystem::exists(ran));
}

TEST_F(GitHeadTest, WakesTheOneWhoWaits) {
  ASSERT_TRUE(Commit());
  std::promise<void> woken;
  GitHead git([&] { woken.set_value(); });
  git.TextOf(file_.path());
  EXPECT_EQ(woken.get_future().wait_for(std::chrono::seconds(20)), std::future_status::ready);
}

TEST(OutputOf, IsNothingIfTheProgramFailsOrIsNotThere) {
  EXPECT_EQ(OutputOf({"printf", "%s", "two words"}), "two words");
  EXPECT_EQ(OutputOf({"false"}), std::nullopt);
  EXPECT_EQ(OutputOf({"no-such-program-at-all"}), std::nullopt);
}

}  // namespace
}  // namespace coppice::editor
