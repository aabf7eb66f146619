#include "editor/panels/popup/key_list.h"

#include <gtest/gtest.h>

#include <iterator>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class KeyListTest : public testing::Test {
 protected:
  KeyListTest() { driver_ = Start(); }
  std::unique_ptr<Driver> Start() {
    EditorOptions options;
    options.keys_file = file_.path();
    auto driver = std::make_unique<Driver>(options);
    driver->Frames();
    return driver;
  }
  std::string TextOfFile() const {
    std::ifstream stream(file_.path());
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  CommandTable& commands() { return driver_->editor.state().commands; }
  void Choose(const std::string& typed) {
    driver_->Press(kKeyF1);
    driver_->Type(typed);
    driver_->Press(kKeyEnter);
    driver_->Frames();
  }

  TemporaryFile file_{"keys", "# mine\n"};
  std::unique_ptr<Driver> driver_;
};

TEST_F(KeyListTest, FindsCommandsByTitleIdAndKeys) {
  EXPECT_EQ(FindCommands(commands(), "file.quit")[0]->id, "file.quit");
  EXPECT_EQ(FindCommands(commands(), "Fit all")[0]->id, "view.fit_all");
  EXPECT_EQ(FindCommands(commands(), "Ctrl+Shift+K")[0]->keys.key, 'K');
  EXPECT_EQ(FindCommands(commands(), "").size(), commands().all().size());
}

TEST_F(KeyListTest, EveryKeyHasANameThatCanBeRead) {
  for (const EditorCommand& command : commands().all()) {
    const auto read = KeysFromString(ToString(command.keys));
    ASSERT_TRUE(read) << command.id << " " << ToString(command.keys);
    EXPECT_EQ(*read, command.keys) << command.id;
  }
}

TEST_F(KeyListTest, ACommandGetsTheKeysThatArePressed) {
  Choose("view.fit_all");
  ASSERT_TRUE(driver_->Has("popup/new_keys"));
  driver_->Press(kKeyF1 + 11, kCtrl | kAlt);
  driver_->Frames();
  EXPECT_EQ(ToString(commands().Find("view.fit_all")->keys), "Ctrl+Alt+F12");
  EXPECT_EQ(TextOfFile(), "# mine\nview.fit_all = Ctrl+Alt+F12\n");
  driver_.reset();
  driver_ = Start();
  EXPECT_EQ(ToString(commands().Find("view.fit_all")->keys), "Ctrl+Alt+F12") << "a restart";
}

TEST_F(KeyListTest, KeysOfAnotherCommandAreTakenAwayAtTheSecondTime) {
  Choose("view.fit_all");
  driver_->Press('O', kCtrl);
  EXPECT_EQ(commands().Find("file.open")->keys.key, 'O');
  ASSERT_TRUE(driver_->Has("popup/new_keys"));
  driver_->Press('O', kCtrl);
  EXPECT_EQ(commands().Find("file.open")->keys.key, 0);
  EXPECT_EQ(ToString(commands().Find("view.fit_all")->keys), "Ctrl+O");
  EXPECT_TRUE(commands().FindConflicts().empty());
}

TEST_F(KeyListTest, DelTakesTheKeysAwayAndBackspaceGivesTheFirstOnesBack) {
  Choose("view.fit_all");
  driver_->Press(kKeyDelete);
  EXPECT_EQ(commands().Find("view.fit_all")->keys.key, 0);
  driver_->Press(kKeyEscape);
  Choose("view.fit_all");
  driver_->Press(kKeyBackspace);
  EXPECT_EQ(commands().Find("view.fit_all")->keys.key, kKeyHome);
  EXPECT_EQ(TextOfFile(), "# mine\n");
}

TEST_F(KeyListTest, ProblemsOfTheFileAreSaid) {
  file_.Write("view.fit = F2\ntree.collapse = Ctrl+S\n");
  driver_ = Start();
  EXPECT_NE(driver_->editor.state().notice.text.find("are not valid"), std::string::npos);
  driver_->Press(kKeyF1);
  EXPECT_TRUE(driver_->Has("popup/keys/problem"));
  driver_->Picture("keys");
  driver_->Type("file.open");
  driver_->Frames();
  EXPECT_TRUE(driver_->Has("popup/keys/file.open"));
}

}  // namespace
}  // namespace coppice::editor
