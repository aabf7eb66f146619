// The pictures of docs/editor.md and of every palette and size. They are kept if COPPICE_PICTURES
// names a folder:
//
//   COPPICE_PICTURES=docs/pictures build/tests/bin/editor_test --gtest_filter='Pictures.*'
#include <gtest/gtest.h>

#include "tests/editor/driver.h"
#include "tests/editor/patrol_file.h"
#include "tests/editor/reference_picture.h"

namespace coppice::editor {
namespace {

EditorOptions Options(PaletteName palette, float scale) {
  EditorOptions options;
  options.settings.palette = palette;
  options.scale = scale;
  return options;
}

// The patrol tree, with one node selected.
void ShowPatrol(Driver& driver, float scale) {
  const TemporaryFile file("patrol.xml", kPatrolFile);
  driver.input.width = 1280 * scale;
  driver.input.height = 800 * scale;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames(8);
  driver.Press(kKeyHome);
  driver.view().Select(driver.view().scene()->FindPath("1.2.1.1"));
  driver.Frames(10);
}

TEST(Pictures, TheEditorInEachPalette) {
  for (const PaletteName palette :
       {PaletteName::kDark, PaletteName::kLight, PaletteName::kColourBlind}) {
    Driver driver(Options(palette, 1));
    ShowPatrol(driver, 1);
    const std::string name = std::string("editor_") + ToString(palette);
    driver.Picture(name);
    if (palette == PaletteName::kDark) driver.Picture("editor");  // of docs/editor.md
    EXPECT_EQ(CompareWithReference(driver.editor.Picture(), name), "");
    const Box canvas = driver.BoxOf("canvas");
    EXPECT_GT(driver.CountColor(canvas, GetPalette(palette).control, 6), 500);
    EXPECT_GT(driver.CountColor(canvas, GetPalette(palette).canvas, 2), 50000);
  }
}

TEST(Pictures, AScreenWithTinyPixelsShowsTheSameTwiceAsLarge) {
  Driver one(Options(PaletteName::kDark, 1));
  ShowPatrol(one, 1);
  Driver two(Options(PaletteName::kDark, 2));
  ShowPatrol(two, 2);
  two.Picture("editor_hidpi");
  const Box small = one.BoxOf("canvas/Patrol/1.1");
  const Box large = two.BoxOf("canvas/Patrol/1.1");
  EXPECT_NEAR(large.width(), 2 * small.width(), 0.1F * large.width());
  EXPECT_NEAR(large.height(), 2 * small.height(), 0.1F * large.height());
}

TEST(Pictures, AComparisonWithWhatWasSaved) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames();
  driver.view().Select(driver.view().scene()->FindPath("1.3"));
  driver.editor.state().commands.Run("edit.delete");
  driver.editor.state().commands.Run("file.compare");
  driver.Frames();
  driver.Press(kKeyEnter);
  driver.Frames(10);
  driver.Picture("comparison");
  const Color removed = GetPalette(PaletteName::kDark).failure;
  EXPECT_GT(driver.CountColor(driver.BoxOf("canvas"), Mix(removed, 0xFF000000, 0.5F), 60), 50);
}

}  // namespace
}  // namespace coppice::editor
