#include "editor/panels/popup/popup_rows.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"
#include "tests/editor/gallery/drawn_text.h"

namespace coppice::editor {
namespace {

// What is asked for stands above its rows, however far these are scrolled.
TEST(PopupRows, ScrollsALongListToTheChosenRow) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.Click("canvas/MainTree/1");
  driver.Press(kKeyTab);
  driver.Frames();
  const Box input = driver.BoxOf("popup/input");
  ASSERT_GT(driver.editor.state().popup.rows, 20U) << "all types are offered";
  for (int i = 0; i < 20; ++i) driver.Press(kKeyDown);
  driver.Frames();
  ASSERT_TRUE(driver.Has("popup/20"));
  const Box chosen = driver.BoxOf("popup/20");
  EXPECT_GE(chosen.min.y, input.max.y);
  EXPECT_LE(chosen.max.y, driver.BoxOf("popup").max.y);
  EXPECT_EQ(driver.BoxOf("popup/input").min.y, input.min.y);
}

TEST(PopupRows, EndAtTheLineOfAPlaceHoweverLongItsFileIsCalled) {
  Driver driver;
  driver.Frames();
  const auto rows = [](const std::string&) {
    std::vector<Choice> choices(1);
    choices[0].title = std::string(80, 't');
    choices[0].note = std::string(200, 'n') + ":4711";
    return choices;
  };
  driver.editor.state().Ask({"Which?", [](const std::string&) { return Outcome(); }, rows, false});
  driver.Frames();
  std::string drawn;
  for (const DrawnGlyph& glyph : DrawnText(driver.editor)) {
    if (driver.BoxOf("popup/0").Contains(glyph.box.center())) {
      drawn += static_cast<char>(glyph.code);
    }
  }
  EXPECT_NE(drawn.find(":4711"), std::string::npos) << drawn;
}

TEST(PopupRows, AreChosenWithTheKeysWhereNothingIsTyped) {
  Driver driver;
  driver.Frames();
  std::string run;
  const auto rows = [&run](const std::string&) {
    std::vector<Choice> choices(2);
    choices[0].title = "first";
    choices[0].run = [&run] { run += "1"; };
    choices[1].title = "second";
    choices[1].run = [&run] { run += "2"; };
    return choices;
  };
  driver.editor.state().Ask({"Which?", [](const std::string&) { return Outcome(); }, rows, false});
  driver.Frames();
  EXPECT_FALSE(driver.Has("popup/input"));
  driver.Press(kKeySpace);
  driver.Press(kKeyDown);
  driver.Press(kKeySpace);
  EXPECT_EQ(run, "12");
  driver.Press(kKeyEnter);
  EXPECT_FALSE(driver.Has("popup"));
}

}  // namespace
}  // namespace coppice::editor
