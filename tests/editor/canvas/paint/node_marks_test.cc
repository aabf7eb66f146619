#include "editor/canvas/paint/node_marks.h"

#include <gtest/gtest.h>

#include "editor/canvas/layout/node_metrics.h"
#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(NodeMarks, AShortNoteIsOneLine) {
  EXPECT_EQ(NoteLines("needs the long pick"), (std::vector<std::string>{"needs the long pick"}));
  EXPECT_TRUE(NoteLines("").empty());
}

TEST(NodeMarks, ANoteIsBrokenBetweenItsWords) {
  const std::vector<std::string> lines =
      NoteLines("Once it is on its way to the station it stays at it.");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], "Once it is on its way to the");
  EXPECT_EQ(lines[1], "station it stays at it.");
}

TEST(NodeMarks, ALongNoteIsCutAndSaysSo) {
  const std::vector<std::string> lines =
      NoteLines(std::string(40, 'a') + " " + std::string(200, 'b'));
  ASSERT_EQ(lines.size(), metrics::kMostNoteLines);
  EXPECT_EQ(lines[0], std::string(metrics::kNoteColumns, 'a'));
  EXPECT_NE(lines[1].find("\xE2\x80\xA6"), std::string::npos);
}

TEST(NodeMarks, NoCharacterOfANoteIsCutInTwo) {
  std::string note;
  for (int i = 0; i < 60; ++i) note += "\xC3\xA4";  // a-umlaut, two bytes
  for (const std::string& line : NoteLines(note)) {
    const auto first = static_cast<unsigned char>(line.front());
    EXPECT_NE(first & 0xC0U, 0x80U) << "it begins in the midst of a character";
  }
}

TEST(NodeMarks, EveryChangeHasAColourOfItsOwn) {
  const Palette& colors = GetPalette(PaletteName::kLight);
  const std::vector<Color> all = {
      ColorOf(colors, Change::kAdded), ColorOf(colors, Change::kRemoved),
      ColorOf(colors, Change::kMoved), ColorOf(colors, Change::kChanged),
      ColorOf(colors, Change::kNone)};
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) EXPECT_NE(all[i], all[j]) << i << j;
  }
}

TEST(NodeMarks, ShowBreakpointsFaultsAndWhereTheTreeStands) {
  Driver driver;
  ExecutedSource* robot = AddExecuted(driver, "robot:1", 10);
  const Palette& colors = GetPalette(PaletteName::kDark);
  ASSERT_TRUE(driver.Click("canvas/Main/1.1"));
  const Box node = driver.BoxOf("canvas/Main/1.1");
  const Box beside = {{node.min.x - 24, node.min.y}, {node.min.x - 2, node.max.y}};
  EXPECT_EQ(driver.CountColor(beside, colors.failure), 0);
  driver.Press(kKeyF1 + 8);
  const int full = driver.CountColor(beside, colors.failure);
  EXPECT_GT(full, 30);
  driver.Press(kKeyF1 + 8, kShift);
  EXPECT_LT(driver.CountColor(beside, colors.failure), full) << "hollow when it is off";
  robot->StopBefore(NodeIndex{1});
  driver.Frames();
  EXPECT_GT(driver.CountColor(beside, colors.running), 20);
}

}  // namespace
}  // namespace coppice::editor
