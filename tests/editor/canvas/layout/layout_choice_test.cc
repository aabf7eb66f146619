#include "editor/canvas/layout/layout_choice.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::editor {
namespace {

constexpr Point kCanvas{740, 620};

// A root with so many branches of three leaves, all of them large with their ports.
MeasuredTree Branches(std::uint32_t count) {
  MeasuredTree tree;
  tree.ends = {4 * count + 1};
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t at = 4 * i + 1;
    tree.ends.insert(tree.ends.end(), {at + 4, at + 2, at + 3, at + 4});
  }
  tree.sizes.assign(tree.ends.size(), NodeSizes({220, 120}, {160, 26}));
  tree.is_decorator.assign(tree.ends.size(), false);
  return tree;
}

ChosenLayout Choose(std::uint32_t branches, const LayoutStyle& style = {}) {
  return ChooseLayout(Branches(branches), style, kCanvas);
}

float ZoomOf(const ChosenLayout& chosen) {
  return std::min(kCanvas.x / chosen.layout.bounds.width(),
                  kCanvas.y / chosen.layout.bounds.height());
}

TEST(LayoutChoice, ShowsPortsTopToBottomWhereTheyCanBeRead) {
  EXPECT_EQ(Choose(1).choice, LayoutChoice());
}

TEST(LayoutChoice, TurnsTheTreeBeforeItGivesUpItsPorts) {
  const ChosenLayout chosen = Choose(2);
  EXPECT_EQ(chosen.choice.orientation, Orientation::kLeftToRight);
  EXPECT_FALSE(chosen.choice.names_only);
}

TEST(LayoutChoice, GivesUpPortsBeforeItBreaksRows) {
  const ChosenLayout chosen = Choose(9);
  EXPECT_TRUE(chosen.choice.names_only);
  EXPECT_EQ(chosen.choice.rows, 0);
}

TEST(LayoutChoice, BreaksRowsForWhatIsTooLongForAnyTidyTree) {
  const ChosenLayout chosen = Choose(16);
  EXPECT_TRUE(chosen.choice.names_only);
  EXPECT_GT(chosen.choice.rows, 0);
  EXPECT_TRUE(chosen.can_be_read);
}

TEST(LayoutChoice, WhatCanBeReadAsAWholeHasNamesOfNinePixels) {
  for (std::uint32_t branches = 1; branches < 40; ++branches) {
    const ChosenLayout chosen = Choose(branches);
    if (!chosen.can_be_read) continue;
    EXPECT_GE(ZoomOf(chosen), chosen.readable) << branches;
    EXPECT_GE(chosen.readable, kReadableNames) << branches;
  }
}

TEST(LayoutChoice, LaysOutLargeTreesAsAPageThatIsAsWideAsTheCanvas) {
  const ChosenLayout chosen = Choose(200);
  EXPECT_FALSE(chosen.can_be_read);
  EXPECT_LE(chosen.layout.bounds.width() * chosen.readable, kCanvas.x + 0.1F);
}

TEST(LayoutChoice, LeavesTheDirectionToTheUser) {
  LayoutStyle style;
  for (const Growth growth : {Growth::kDown, Growth::kAcross}) {
    style.growth = growth;
    for (const std::uint32_t branches : {1U, 5U, 16U, 200U}) {
      const bool across = Choose(branches, style).choice.orientation == Orientation::kLeftToRight;
      EXPECT_EQ(across, growth == Growth::kAcross) << branches;
    }
  }
}

TEST(LayoutChoice, LeavesPortsAndRowsToTheUser) {
  LayoutStyle style;
  style.ports = ShownPorts::kAll;
  EXPECT_FALSE(Choose(16, style).choice.names_only);
  style.ports = ShownPorts::kNone;
  EXPECT_TRUE(Choose(1, style).choice.names_only);
  style.wrapped = false;
  EXPECT_EQ(Choose(16, style).choice.rows, 0);
  EXPECT_EQ(Choose(200, style).choice.rows, 0);
}

TEST(LayoutChoice, AcceptsAnEmptyTree) {
  EXPECT_TRUE(ChooseLayout({}, {}, kCanvas).layout.boxes.empty());
}

}  // namespace
}  // namespace coppice::editor
