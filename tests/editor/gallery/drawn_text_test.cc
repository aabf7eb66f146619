#include "tests/editor/gallery/drawn_text.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

DrawnGlyph Glyph(float x, int text, Color color = 0xFFFFFFFF) {
  return {'a', {{x, 0}, {x + 8, 8}}, {{0, 0}, {100, 100}}, color, 0xFF000000, text};
}

TEST(DrawnText, FindsWhatIsWrittenAndWhatIsBehindIt) {
  Driver driver;
  driver.Frames();
  const std::vector<DrawnGlyph> glyphs = DrawnTextOnBackground(driver.editor);
  const Box title = driver.BoxOf("menu/file");
  std::string text;
  for (const DrawnGlyph& glyph : glyphs) {
    if (!title.Contains(glyph.box.center())) continue;
    text += static_cast<char>(glyph.code);
    EXPECT_EQ(glyph.background, GetPalette(PaletteName::kDark).panel);
  }
  EXPECT_EQ(text, "File");
}

TEST(DrawnText, LeavesOutWhatAPopupCovers) {
  Driver driver;
  driver.Frames();
  const auto count_field = [&] {
    int count = 0;
    for (const DrawnGlyph& glyph : DrawnText(driver.editor)) {
      count += driver.BoxOf("canvas").Contains(glyph.box.center());
    }
    return count;
  };
  const int before = count_field();
  driver.Press('P', kCtrl);
  driver.Press(kKeyEscape);
  EXPECT_EQ(count_field(), before);
}

TEST(DrawnText, FaintTextIsReported) {
  EXPECT_TRUE(FaintTexts({Glyph(0, 1)}).empty());
  EXPECT_EQ(FaintTexts({Glyph(0, 1, 0xFF444444), Glyph(10, 1, 0xFF444444)}).size(), 1U);
  EXPECT_TRUE(FaintTexts({Glyph(0, 1, 0x40FFFFFF)}).empty()) << "faded on purpose";
}

TEST(DrawnText, TextBeyondItsClipIsCut) {
  EXPECT_TRUE(CutTexts({Glyph(90, 1)}, {}).empty());
  EXPECT_EQ(CutTexts({Glyph(96, 1)}, {}).size(), 1U);
  EXPECT_TRUE(CutTexts({Glyph(96, 1)}, {{{50, 0}, {200, 50}}}).empty()) << "it can be scrolled";
}

TEST(DrawnText, TextThatLeavesItsBoxIsReported) {
  const std::vector<Box> boxes = {{{0, 0}, {20, 20}}};
  EXPECT_TRUE(StrayTexts({Glyph(0, 1), Glyph(10, 1)}, boxes).empty());
  EXPECT_EQ(StrayTexts({Glyph(0, 1), Glyph(10, 1), Glyph(20, 1)}, boxes).size(), 1U);
  EXPECT_TRUE(StrayTexts({Glyph(30, 1), Glyph(40, 1)}, boxes).empty()) << "it is elsewhere";
  EXPECT_TRUE(StrayTexts({Glyph(10, 1), Glyph(20, 2)}, boxes).empty()) << "another text";
}

TEST(DrawnText, TextOverTextIsReported) {
  EXPECT_TRUE(OverlappingTexts({Glyph(0, 1), Glyph(4, 1)}).empty()) << "of one text";
  EXPECT_EQ(OverlappingTexts({Glyph(0, 1), Glyph(4, 2)}).size(), 1U);
  EXPECT_TRUE(OverlappingTexts({Glyph(0, 1), Glyph(7, 2)}).empty());
}

}  // namespace
}  // namespace coppice::editor
