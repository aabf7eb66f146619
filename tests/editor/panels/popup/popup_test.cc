#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Popup, OpensAFileByItsPath) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.Frames();
  driver.Press('O', kCtrl);
  driver.Type(file.path());
  driver.Press(kKeyEnter);
  EXPECT_TRUE(driver.Has("canvas/MainTree/1"));
  EXPECT_FALSE(driver.Has("popup"));
}

TEST(Popup, StaysAndSaysWhyAFileCannotBeOpened) {
  Driver driver;
  driver.Frames();
  driver.Press('O', kCtrl);
  driver.Type("/nowhere.xml");
  driver.Press(kKeyEnter);
  EXPECT_TRUE(driver.Has("popup/input"));
  EXPECT_NE(driver.editor.state().popup.error, "");
}

TEST(Popup, HasRoomForItsErrorWithoutRows) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.Press('H', kCtrl);
  driver.Type("nowhere");
  driver.Press(kKeyEnter);
  driver.Frames();
  ASSERT_EQ(driver.editor.state().popup.error, "not found");
  EXPECT_LT(driver.BoxOf("popup/error").max.y, driver.BoxOf("popup").max.y - 4);
}

TEST(Popup, RunsTheChosenCommandOfThePalette) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.Press('P', kCtrl);
  driver.Type("light col");
  driver.Picture("palette");
  driver.Press(kKeyEnter);
  EXPECT_EQ(driver.editor.state().screen.palette, PaletteName::kLight);
}

TEST(Popup, JumpsToANodeByTyping) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.Press('P', kCtrl);
  driver.Type("switchon");
  ASSERT_TRUE(driver.Click("popup/0"));
  EXPECT_EQ(driver.Selected(), "1.1.2");
}

TEST(Popup, MovesTheChoiceWithTheArrowKeys) {
  Driver driver;
  driver.Frames();
  driver.Press('P', kCtrl);
  driver.Press(kKeyDown);
  driver.Press(kKeyDown);
  driver.Press(kKeyUp);
  EXPECT_EQ(driver.editor.state().popup.choice, 1);
}

TEST(Popup, KeepsKeysToItselfWhileTextIsTyped) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.Click("canvas/MainTree/1.2");
  driver.Press('P', kCtrl);
  driver.Press('C');
  driver.Press('Q', kCtrl);
  EXPECT_FALSE(driver.view().IsCollapsed(driver.view().selected()));
  EXPECT_FALSE(driver.editor.wants_quit());
}

TEST(Popup, ConnectsToARobot) {
  Driver driver;
  driver.Frames();
  driver.Press('K', kCtrl);
  driver.Press('A', kCtrl);
  driver.Type("localhost:1");
  driver.Press(kKeyEnter);
  ASSERT_EQ(driver.editor.state().workspace.runs().size(), 1U);
  EXPECT_TRUE(driver.Has("strip/localhost:1"));
}

TEST(Popup, ListsAllKeys) {
  Driver driver;
  driver.Frames();
  driver.Press(kKeyF1);
  driver.Type("file.open");
  driver.Frames();
  EXPECT_TRUE(driver.Has("popup/keys/file.open"));
  driver.Press(kKeyEscape);
  EXPECT_FALSE(driver.Has("popup"));
}

TEST(Popup, ClosesByAClickBesideIt) {
  Driver driver;
  driver.Frames();
  driver.Press('P', kCtrl);
  driver.ClickAt({600, 700});
  EXPECT_FALSE(driver.Has("popup"));
}

TEST(Popup, IsHighEnoughForALongQuestion) {
  Driver driver;
  driver.Frames();
  driver.editor.state().Ask({"Short?", [](const std::string&) { return Outcome(); }, {}});
  driver.Frames();
  const float low = driver.BoxOf("popup").height();
  std::string question;
  for (int i = 0; i < 30; ++i) question += "a long question ";
  driver.editor.state().Ask({question, [](const std::string&) { return Outcome(); }, {}});
  driver.Frames();
  EXPECT_GT(driver.BoxOf("popup").height(), low + 20);
  EXPECT_LE(driver.BoxOf("popup/input").max.y, driver.BoxOf("popup").max.y);
}

TEST(Popup, DoesNotAddAFileThatThereIsNot) {
  Driver driver;
  driver.Frames();
  driver.Press('O', kCtrl);
  driver.Type("/no/such/file.xml");
  driver.Press(kKeyEnter);
  EXPECT_EQ(driver.editor.state().popup.error, "/no/such/: No such file or directory");
  EXPECT_TRUE(driver.editor.state().workspace.files().empty());
}

}  // namespace
}  // namespace coppice::editor
