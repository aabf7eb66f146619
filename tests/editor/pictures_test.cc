// The pictures of docs/editor.md and of every palette and size. They are kept if COPPICE_PICTURES
// names a folder:
//
//   COPPICE_PICTURES=docs/pictures build/tests/bin/editor_test --gtest_filter='Pictures.*'
#include <gtest/gtest.h>

#include "tests/editor/driver.h"
#include "tests/editor/reference_picture.h"

namespace coppice::editor {
namespace {

// A robot that walks its round and charges when it must: every shape, keys, a note.
constexpr char kPatrol[] = R"(<?xml version="1.0" encoding="UTF-8"?>
<root BTCPP_format="4" main_tree_to_execute="Patrol">
  <BehaviorTree ID="Patrol">
    <ReactiveFallback name="patrol">
      <!-- Once it is on its way to the station it stays at it. -->
      <Sequence name="recharge when low">
        <IsBatteryLow level="{battery}" threshold="0.3"/>
        <SubTree ID="GoTo" name="to the station" goal="{station}"/>
        <Charge until="0.95" level="{battery}"/>
      </Sequence>
      <Repeat name="rounds" num_cycles="-1">
        <Sequence name="round">
          <ChooseWaypoint waypoint="{goal}"/>
          <SubTree ID="GoTo" name="to the waypoint" goal="{goal}"/>
          <Say text="All quiet."/>
        </Sequence>
      </Repeat>
    </ReactiveFallback>
  </BehaviorTree>
  <BehaviorTree ID="GoTo">
    <RetryUntilSuccessful name="until there" num_attempts="3">
      <Fallback name="drive or pause">
        <NavigateTo goal="{goal}"/>
        <ForceFailure name="pause"><Wait seconds="5"/></ForceFailure>
      </Fallback>
    </RetryUntilSuccessful>
  </BehaviorTree>
  <TreeNodesModel>
    <Condition ID="IsBatteryLow"><input_port name="level" type="double">of charge</input_port>
      <input_port name="threshold" type="double">low below it</input_port></Condition>
    <Action ID="Charge"><input_port name="level" type="double">of charge</input_port>
      <input_port name="until" type="double">level to leave at</input_port></Action>
    <Action ID="ChooseWaypoint"><output_port name="waypoint" type="Pose2D">next</output_port>
      </Action>
    <Action ID="NavigateTo"><input_port name="goal" type="Pose2D">where to</input_port></Action>
    <Action ID="Say"><input_port name="text" type="string">what</input_port></Action>
    <Action ID="Wait"><input_port name="seconds" type="double">how long</input_port></Action>
  </TreeNodesModel>
</root>
)";

EditorOptions Options(PaletteName palette, float scale) {
  EditorOptions options;
  options.palette = palette;
  options.scale = scale;
  return options;
}

// The patrol tree, with one node selected.
void ShowPatrol(Driver& driver, float scale) {
  const TemporaryFile file("patrol.xml", kPatrol);
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
