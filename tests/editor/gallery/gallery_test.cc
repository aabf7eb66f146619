// Rules for everything that the editor shows, in every palette.
#include <gtest/gtest.h>

#include <ostream>

#include "tests/editor/gallery/drawn_text.h"
#include "tests/editor/gallery/scenes.h"

namespace coppice::editor {

// What a failed test is called.
void PrintTo(const GalleryScene& scene, std::ostream* stream) { *stream << scene.name; }

namespace {

std::string Lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "\n  " + line;
  return text;
}

class Gallery : public testing::TestWithParam<GalleryScene> {};

// Where the user scrolls or moves the text, it may go on beyond the edge.
void ExpectWholeTexts(const Editor& editor, const std::vector<DrawnGlyph>& text) {
  std::vector<Box> scrolled;
  for (const auto& [path, box] : editor.items().all()) {
    const bool is_field = path.rfind("inspector/", 0) == 0 || path == "popup/input";
    if (path == "canvas" || path == "xml" || is_field) scrolled.push_back(box);
  }
  const std::vector<std::string> cut = CutTexts(text, scrolled);
  EXPECT_TRUE(cut.empty()) << Lines(cut);
  const std::vector<std::string> overlapping = OverlappingTexts(text);
  EXPECT_TRUE(overlapping.empty()) << Lines(overlapping);
}

TEST_P(Gallery, IsWholeAndReadableInEveryPalette) {
  Stage stage({});
  GetParam().play(stage);
  const Editor& editor = stage.driver().editor;
  ExpectWholeTexts(editor, DrawnText(editor));
  for (const PaletteName palette :
       {PaletteName::kDark, PaletteName::kLight, PaletteName::kColourBlind}) {
    stage.state().palette = palette;
    stage.driver().Frames(2);
    const std::vector<std::string> faint = FaintTexts(DrawnText(editor));
    EXPECT_TRUE(faint.empty()) << ToString(palette) << Lines(faint);
  }
}

TEST_P(Gallery, IsWholeOnAScreenWithTinyPixels) {
  GalleryLook look;
  look.scale = 2;
  look.width *= look.scale;
  look.height *= look.scale;
  Stage stage(look);
  GetParam().play(stage);
  ExpectWholeTexts(stage.driver().editor, DrawnText(stage.driver().editor));
}

// The picture of docs/editor.md; kept as those of pictures_test.cc.
TEST(GalleryPicture, ALiveRun) {
  for (const GalleryScene& scene : RunScenes()) {
    if (std::string(scene.name) != "live") continue;
    Stage stage({});
    scene.play(stage);
    stage.driver().Picture("editor_live");
    EXPECT_TRUE(stage.driver().Has("timeline/mission"));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Gallery, testing::ValuesIn(GalleryScenes()),
                         [](const auto& scene) { return std::string(scene.param.name); });

}  // namespace
}  // namespace coppice::editor
