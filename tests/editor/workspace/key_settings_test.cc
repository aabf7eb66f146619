#include "editor/workspace/key_settings.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class KeySettingsTest : public testing::Test {
 protected:
  KeySettingsTest() { state().key_settings.file = file_.path(); }
  EditorState& state() { return driver_.editor.state(); }
  KeyChord KeysOf(const std::string& id) { return state().commands.Find(id)->keys; }
  std::string Disk() const {
    std::ifstream stream(file_.path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  TemporaryFile file_{"keys", "# mine\n"};
  Driver driver_;
};

TEST_F(KeySettingsTest, NewKeysHoldAtOnceAndLieInTheFile) {
  GiveKeys(state(), "view.fit_all", {kKeyHome, kCtrl | kAlt}, 0);
  EXPECT_EQ(KeysOf("view.fit_all"), (KeyChord{kKeyHome, kCtrl | kAlt}));
  EXPECT_EQ(Disk().rfind("# mine\n", 0), 0U) << "what else is there stays";
  EXPECT_NE(Disk().find("view.fit_all = "), std::string::npos) << Disk();
  GiveOwnKeys(state(), "view.fit_all", 0);
  EXPECT_EQ(KeysOf("view.fit_all"), (KeyChord{kKeyHome}));
  EXPECT_EQ(Disk(), "# mine\n");
}

TEST_F(KeySettingsTest, KeysOfAnotherCommandAreTakenFromIt) {
  const EditorCommand& fit = *state().commands.Find("view.fit_all");
  const KeyChord undo = KeysOf("edit.undo");
  ASSERT_NE(OtherWithKeys(state(), fit, undo), nullptr);
  EXPECT_EQ(OtherWithKeys(state(), fit, undo)->id, "edit.undo");
  EXPECT_EQ(OtherWithKeys(state(), fit, {}), nullptr) << "having none is no conflict";
  GiveKeys(state(), "view.fit_all", undo, 0);
  EXPECT_EQ(KeysOf("view.fit_all"), undo);
  EXPECT_EQ(KeysOf("edit.undo"), KeyChord{});
}

TEST_F(KeySettingsTest, KeysThatCountWhileARunIsShownDoNotGetInTheWay) {
  const EditorCommand& run = *state().commands.Find("run.why");
  const EditorCommand* always = nullptr;
  for (const EditorCommand& command : state().commands.all()) {
    if (!command.when && command.keys.key != 0) always = &command;
  }
  ASSERT_NE(always, nullptr);
  EXPECT_EQ(OtherWithKeys(state(), run, always->keys), nullptr);
}

TEST_F(KeySettingsTest, AFileThatCannotBeWrittenIsSaid) {
  state().key_settings.file = "/proc/none/keys";
  GiveKeys(state(), "view.fit_all", {kKeyHome, kCtrl | kAlt}, 0);
  EXPECT_TRUE(state().notice.is_refusal);
  EXPECT_EQ(KeysOf("view.fit_all"), (KeyChord{kKeyHome, kCtrl | kAlt})) << "it holds all the same";
}

}  // namespace
}  // namespace coppice::editor
