// Rules for everything that the editor shows, in every palette.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

// On the canvas: "canvas/TREE/PATH". None while something is dragged over them.
std::vector<Box> NodesOf(Editor& editor) {
  std::vector<Box> nodes;
  const TreeView* view = editor.state().workspace.view();
  const bool is_drag = view && view->gesture.kind == Gesture::Kind::kDrag;
  if (is_drag || editor.state().drag.carried) return nodes;
  for (const auto& [path, box] : editor.items().all()) {
    const bool is_node =
        path.rfind("canvas/", 0) == 0 && std::count(path.begin(), path.end(), '/') == 2;
    if (is_node) nodes.push_back(box);
  }
  return nodes;
}

// Popups, which lie over the canvas, are clipped by themselves.
std::vector<DrawnGlyph> OnCanvas(const Editor& editor, const std::vector<DrawnGlyph>& text) {
  const Box* const canvas = editor.items().Find("canvas");
  std::vector<DrawnGlyph> found;
  for (const DrawnGlyph& glyph : text) {
    const bool is_there = canvas && std::abs(glyph.clip.min.x - canvas->min.x) < 1 &&
                          std::abs(glyph.clip.max.x - canvas->max.x) < 1;
    if (is_there) found.push_back(glyph);
  }
  return found;
}

// What the cursor of the timeline or a minimap that one sees through does not lie on.
std::vector<DrawnGlyph> Uncovered(Editor& editor, std::vector<DrawnGlyph> text) {
  const TreeView* const view = editor.state().workspace.view();
  std::vector<const Box*> covers = {editor.items().Find("timeline/cursor")};
  if (view && view->minimap.covers) covers.push_back(editor.items().Find("canvas/minimap"));
  const auto is_covered = [&covers](const DrawnGlyph& glyph) {
    return std::any_of(covers.begin(), covers.end(),
                       [&glyph](const Box* cover) { return cover && cover->Overlaps(glyph.box); });
  };
  text.erase(std::remove_if(text.begin(), text.end(), is_covered), text.end());
  return text;
}

// Where the user scrolls or moves the text, it may go on beyond the edge.
void ExpectWholeTexts(Editor& editor, const std::vector<DrawnGlyph>& text) {
  std::vector<Box> scrolled;
  for (const auto& [path, box] : editor.items().all()) {
    const bool is_field = path.rfind("inspector/", 0) == 0 || path == "popup/input";
    if (path == "canvas" || path == "xml" || is_field) scrolled.push_back(box);
  }
  const std::vector<std::string> cut = CutTexts(text, scrolled);
  EXPECT_TRUE(cut.empty()) << Lines(cut);
  const std::vector<std::string> stray = StrayTexts(OnCanvas(editor, text), NodesOf(editor));
  EXPECT_TRUE(stray.empty()) << Lines(stray);
  const std::vector<std::string> overlapping = OverlappingTexts(text);
  EXPECT_TRUE(overlapping.empty()) << Lines(overlapping);
}

// A suite for each screen: they are tests of their own to ctest, which runs them side by side.
class GalleryOnAScreen : public testing::TestWithParam<GalleryScene> {
 protected:
  explicit GalleryOnAScreen(const GalleryLook& look) : stage_(look) { GetParam().play(stage_); }

  Editor& editor() { return stage_.driver().editor; }

  Stage stage_;
};

class GallerySmall : public GalleryOnAScreen {
 protected:
  GallerySmall() : GalleryOnAScreen({}) {}
};

class GalleryLarge : public GalleryOnAScreen {
 protected:
  GalleryLarge() : GalleryOnAScreen({PaletteName::kDark, 2560, 1440, 1}) {}
};

class GalleryTinyPixels : public GalleryOnAScreen {
 protected:
  GalleryTinyPixels() : GalleryOnAScreen({PaletteName::kDark, 2560, 1600, 2}) {}
};

TEST_P(GallerySmall, IsWholeAndReadableInEveryPalette) {
  ExpectWholeTexts(editor(), DrawnText(editor()));
  for (const PaletteName palette :
       {PaletteName::kDark, PaletteName::kLight, PaletteName::kColourBlind}) {
    stage_.state().screen.palette = palette;
    stage_.driver().Frames(2);
    const std::vector<std::string> faint =
        FaintTexts(Uncovered(editor(), DrawnTextOnBackground(editor())));
    EXPECT_TRUE(faint.empty()) << ToString(palette) << Lines(faint);
  }
}

TEST_P(GalleryLarge, IsWhole) { ExpectWholeTexts(editor(), DrawnText(editor())); }

TEST_P(GalleryTinyPixels, IsWhole) { ExpectWholeTexts(editor(), DrawnText(editor())); }

// The pictures of docs/editor.md; kept as those of pictures_test.cc.
void KeepPicture(const std::string& scene_name, const std::string& picture,
                 const std::string& needed) {
  for (const GalleryScene& scene : RunScenes()) {
    if (scene.name != scene_name) continue;
    Stage stage({});
    scene.play(stage);
    stage.driver().Picture(picture);
    EXPECT_TRUE(stage.driver().Has(needed));
  }
}

TEST(GalleryPicture, ALiveRun) { KeepPicture("live", "editor_live", "timeline/mission"); }

TEST(GalleryPicture, TheFaceOfARobot) { KeepPicture("face", "editor_face", "run/pictures/face"); }

std::string NameOf(const testing::TestParamInfo<GalleryScene>& scene) { return scene.param.name; }

INSTANTIATE_TEST_SUITE_P(Scenes, GallerySmall, testing::ValuesIn(GalleryScenes()), NameOf);
INSTANTIATE_TEST_SUITE_P(Scenes, GalleryLarge, testing::ValuesIn(GalleryScenes()), NameOf);
INSTANTIATE_TEST_SUITE_P(Scenes, GalleryTinyPixels, testing::ValuesIn(GalleryScenes()), NameOf);

}  // namespace
}  // namespace coppice::editor
