#include <gmock/gmock.h>
#include <sys/fsuid.h>
#include <unistd.h>

#include <filesystem>

#include "editor/workspace/file_dialog.h"
#include "tests/editor/driver.h"
#include "tests/editor/reference_picture.h"

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;

class FilesStory : public testing::Test {
 protected:
  FilesStory() {
    fs::create_directories(folder_.Path("robots/kitchen"));
    WriteFile(folder_.Path("robots/round.xml"), kSmallFile);
    WriteFile(folder_.Path("robots/kitchen/stove.xml"), kSmallFile);
    WriteFile(folder_.Path("robots/notes.txt"), "nothing for us");
  }

  EditorState& state() { return driver_.editor.state(); }
  void OpenDialogIn(const std::string& folder) {
    driver_.Press('O', kCtrl);
    driver_.Type(folder + "/");
    driver_.Frames();
  }
  std::vector<std::string> Titles() {
    std::vector<std::string> titles;
    for (const FileRow& row : FileRows(state())) titles.push_back(row.title);
    return titles;
  }
  std::string ShownFile() {
    return state().workspace.file() ? state().workspace.file()->path : std::string();
  }

  TemporaryFolder folder_;
  Driver driver_;
};

TEST_F(FilesStory, TheDialogListsFoldersFirstAndFilesThatItCanOpen) {
  OpenDialogIn(folder_.Path("robots"));
  EXPECT_THAT(Titles(), testing::ElementsAre("../", "kitchen/", "round.xml"));
}

TEST_F(FilesStory, TabCompletesAFolderAndThenAFile) {
  OpenDialogIn(folder_.path());
  driver_.Type("rob");
  driver_.Press(kKeyTab);
  EXPECT_EQ(state().popup.text, folder_.Path("robots/"));
  driver_.Type("rnd");
  driver_.Press(kKeyTab);
  EXPECT_EQ(state().popup.text, folder_.Path("robots/round.xml"));
  driver_.Press(kKeyEnter);
  EXPECT_EQ(ShownFile(), folder_.Path("robots/round.xml"));
}

TEST_F(FilesStory, EnterOpensAFolderAndBackspaceGoesUp) {
  OpenDialogIn(folder_.Path("robots"));
  driver_.Type("kit");
  driver_.Press(kKeyEnter);
  EXPECT_EQ(state().popup.text, "");
  EXPECT_EQ(ShownFolder(state()), folder_.Path("robots/kitchen"));
  driver_.Press(kKeyBackspace);
  EXPECT_EQ(ShownFolder(state()), folder_.Path("robots"));
  driver_.Type("kit");
  driver_.Press(kKeyEnter);
  driver_.Type("sto");
  driver_.Press(kKeyEnter);
  EXPECT_EQ(ShownFile(), folder_.Path("robots/kitchen/stove.xml"));
}

TEST_F(FilesStory, ARowOpensWithAClick) {
  OpenDialogIn(folder_.Path("robots"));
  ASSERT_TRUE(driver_.Click("popup/2"));
  EXPECT_EQ(ShownFile(), folder_.Path("robots/round.xml"));
}

TEST_F(FilesStory, ARobotIsOpenedFromTheSamePlace) {
  driver_.Press('O', kCtrl);
  driver_.Type("127.0.0.1:9");
  driver_.Press(kKeyEnter);
  ASSERT_NE(state().workspace.run(), nullptr);
  EXPECT_EQ(state().workspace.run()->name(), "127.0.0.1:9");
}

TEST_F(FilesStory, RecentFilesAndTheirFoldersAreOfferedAndThoseThatAreGoneAreNot) {
  state().recent.files = {folder_.Path("robots/kitchen/stove.xml"), folder_.Path("gone.xml")};
  driver_.Press('O', kCtrl);
  driver_.Type("stove");
  EXPECT_THAT(Titles(), testing::Contains(folder_.Path("robots/kitchen/stove.xml")));
  driver_.Press(kKeyEnter);
  EXPECT_EQ(ShownFile(), folder_.Path("robots/kitchen/stove.xml"));
  driver_.Press('O', kCtrl);
  EXPECT_THAT(Titles(), testing::Contains(folder_.Path("robots/kitchen/")));
  EXPECT_THAT(Titles(), testing::Not(testing::Contains(folder_.Path("gone.xml"))));
}

TEST_F(FilesStory, ExamplesAreOffered) {
  driver_.Press('O', kCtrl);
  EXPECT_THAT(Titles(), testing::Contains("Delivery: a tree"));
}

TEST_F(FilesStory, AFolderThatIsGoneSaysSoInTheSystemsWords) {
  OpenDialogIn(folder_.Path("nowhere"));
  EXPECT_THAT(state().popup.error, testing::HasSubstr("No such file or directory"));
}

// For this thread alone: root may read everything, and tests run as root here and there.
class WithoutTheRightsOfRoot {
 public:
  WithoutTheRightsOfRoot() { setfsuid(kNobody); }
  ~WithoutTheRightsOfRoot() { setfsuid(geteuid()); }
  WithoutTheRightsOfRoot(const WithoutTheRightsOfRoot&) = delete;
  WithoutTheRightsOfRoot& operator=(const WithoutTheRightsOfRoot&) = delete;

 private:
  static constexpr uid_t kNobody = 65534;
};

TEST_F(FilesStory, AFolderThatMayNotBeReadSaysSoInTheSystemsWords) {
  fs::permissions(folder_.path(), fs::perms(0755));
  fs::permissions(folder_.Path("robots"), fs::perms::none);
  {
    const WithoutTheRightsOfRoot rights;
    OpenDialogIn(folder_.Path("robots"));
    EXPECT_THAT(state().popup.error, testing::HasSubstr("Permission denied"));
  }
  driver_.Picture("story_no_permission");
  fs::permissions(folder_.Path("robots"), fs::perms(0755));
}

TEST_F(FilesStory, SaveAsUsesTheSameDialog) {
  ASSERT_TRUE(driver_.editor.Open(folder_.Path("robots/round.xml")));
  driver_.Press('S', kCtrl | kShift);
  EXPECT_EQ(state().popup.text, "round.xml");
  driver_.Press(kKeyDown);
  driver_.Press(kKeyEnter);
  EXPECT_EQ(ShownFolder(state()), folder_.Path("robots/kitchen"));
  EXPECT_EQ(state().popup.text, "round.xml") << "the name stays";
  driver_.Press(kKeyEnter);
  EXPECT_TRUE(fs::exists(folder_.Path("robots/kitchen/round.xml")));
}

}  // namespace
}  // namespace coppice::editor
