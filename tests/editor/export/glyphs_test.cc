#include "editor/export/glyphs.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::editor {
namespace {

Box BoundsOf(const std::vector<GlyphStep>& steps) {
  Box box = {steps.front().to, steps.front().to};
  for (const GlyphStep& step : steps) box = Union(box, {step.to, step.to});
  return box;
}

TEST(Glyphs, AreAsWideAsAskedForAndStandOnTheBaseLine) {
  const Glyphs glyphs;
  const auto steps = glyphs.OutlineOf("HHHH", Face::kSans, 20, {100, 50}, 80);
  ASSERT_FALSE(steps.empty());
  const Box box = BoundsOf(steps);
  EXPECT_GT(box.min.x, 100);
  EXPECT_LT(box.max.x, 180);
  EXPECT_GT(box.width(), 70);
  EXPECT_NEAR(box.max.y, 50, 0.01);            // an H stands on the line
  EXPECT_NEAR(box.height(), 20 * 0.73F, 0.5);  // capitals of DejaVu
}

TEST(Glyphs, EveryContourBeginsWithAMove) {
  const Glyphs glyphs;
  for (const Face face : {Face::kSans, Face::kBold, Face::kMono}) {
    const auto steps = glyphs.OutlineOf("Bo\xC3\xA4", face, 10, {0, 0}, 0);
    ASSERT_FALSE(steps.empty());
    EXPECT_EQ(steps.front().kind, GlyphStep::Kind::kMove);
  }
}

TEST(Glyphs, KnowTheIcons) {
  const Glyphs glyphs;
  EXPECT_FALSE(glyphs.OutlineOf("\xEF\x83\xA7", Face::kBold, 12, {0, 0}, 0).empty());
}

TEST(Glyphs, KnowTheCharactersOfEastAsia) {
  const Glyphs glyphs;
  for (const Face face : {Face::kSans, Face::kBold, Face::kMono}) {
    const auto steps = glyphs.OutlineOf("\xE6\x88\xBF", face, 20, {0, 0}, 0);
    ASSERT_FALSE(steps.empty());
    EXPECT_GT(BoundsOf(steps).width(), 12);
    EXPECT_LT(BoundsOf(steps).width(), 22);
  }
}

TEST(Glyphs, NothingIsDrawnForBlanks) {
  EXPECT_TRUE(Glyphs().OutlineOf("  ", Face::kSans, 12, {0, 0}, 10).empty());
}

TEST(CodePoints, AreTheCharactersOfAText) {
  EXPECT_EQ(CodePoints("a\xC3\xA4\xE2\x86\x92\xF0\x9F\x98\x80"),
            (std::vector<std::uint32_t>{'a', 0xE4, 0x2192, 0x1F600}));
}

TEST(CodePoints, ReplaceWhatIsNoUtf8) {
  EXPECT_EQ(CodePoints("\xFF"
                       "a\xC3"),
            (std::vector<std::uint32_t>{0xFFFD, 'a', 0xFFFD}));
}

}  // namespace
}  // namespace coppice::editor
