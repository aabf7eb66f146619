#include "editor/panels/xml/xml_line.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(XmlLine, IsColoured) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.OpenRow();
  const Palette& palette = GetPalette(PaletteName::kDark);
  const Box line = driver.BoxOf("xml/2");
  EXPECT_GT(driver.CountColor(line, palette.accent, 40), 10);
  EXPECT_GT(driver.CountColor(line, palette.link, 40), 10);
}

TEST(XmlLine, AClickSetsTheCaretBetweenTwoCharacters) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.OpenRow();
  const Box line = driver.BoxOf("xml/2");
  driver.ClickAt({line.min.x + 44 + 1, line.center().y});
  EXPECT_EQ(driver.editor.state().xml.pane.at, std::string(kSmallFile).find("<root"));
  driver.ClickAt({line.max.x - 30, line.center().y});
  EXPECT_EQ(driver.editor.state().xml.pane.at, std::string(kSmallFile).find("\n  <Behavior"));
}

}  // namespace
}  // namespace coppice::editor
