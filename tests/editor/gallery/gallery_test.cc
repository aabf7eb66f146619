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

TEST_P(Gallery, IsReadableInEveryPalette) {
  Stage stage({});
  GetParam().play(stage);
  for (const PaletteName palette :
       {PaletteName::kDark, PaletteName::kLight, PaletteName::kColourBlind}) {
    stage.driver().editor.state().palette = palette;
    stage.driver().Frames(2);
    const std::vector<std::string> faint = FaintTexts(DrawnText(stage.driver().editor));
    EXPECT_TRUE(faint.empty()) << ToString(palette) << Lines(faint);
  }
}

// Where the user scrolls or moves the text, it may go on beyond the edge.
TEST_P(Gallery, CutsNoTextAndWritesNoneOverAnother) {
  for (const float scale : {1.0F, 2.0F}) {
    GalleryLook look;
    look.width *= scale;
    look.height *= scale;
    look.scale = scale;
    Stage stage(look);
    GetParam().play(stage);
    const std::vector<DrawnGlyph> text = DrawnText(stage.driver().editor);
    std::vector<Box> scrolled;
    for (const auto& [path, box] : stage.driver().editor.items().all()) {
      const bool is_field = path.rfind("inspector/", 0) == 0 || path == "popup/input";
      if (path == "canvas" || path == "xml" || is_field) scrolled.push_back(box);
    }
    const std::vector<std::string> cut = CutTexts(text, scrolled);
    EXPECT_TRUE(cut.empty()) << scale << Lines(cut);
    const std::vector<std::string> overlapping = OverlappingTexts(text);
    EXPECT_TRUE(overlapping.empty()) << scale << Lines(overlapping);
  }
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
