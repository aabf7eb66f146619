#include "editor/theme/ui.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "editor/theme/imgui_context.h"
#include "tests/editor/shared_fonts.h"

namespace coppice::editor {
namespace {

class UiTest : public testing::Test {
 protected:
  UiTest() : current_(context_) {}
  ~UiTest() override { ImGui::DestroyContext(context_); }
  const std::shared_ptr<const Fonts> fonts_ = SharedFonts(1);
  ImGuiContext* const context_ = fonts_->MakeContext();
  const WithContext current_;
  ItemRegistry items_;
  Ui ui_{GetPalette(PaletteName::kDark), *fonts_, items_, 1, 0, Time{}};
};

TEST_F(UiTest, CutsTextThatIsTooWideAndSaysHowWideItIs) {
  ImDrawListSharedData shared;
  ImDrawList list(&shared);
  list._ResetForNewFrame();
  list.PushClipRect({0, 0}, {1000, 1000});
  list.PushTextureID(ImGui::GetIO().Fonts->TexID);
  const TextStyle style{Face::kSans, 13, 0xFFFFFFFF};
  const float full = ui_.Width("a rather long line of text", style);
  EXPECT_EQ(ui_.RowText(list, {0, 0}, 20, "a rather long line of text", style), full);
  const float cut = ui_.RowText(list, {0, 0}, 20, "a rather long line of text", style, full / 2);
  EXPECT_LE(cut, full / 2);
  EXPECT_GT(cut, full / 3);
  EXPECT_EQ(ui_.RowText(list, {0, 0}, 20, {}, style), 0);
}

TEST_F(UiTest, CutsTheStartOfAPath) {
  const TextStyle style{Face::kSans, 13, 0xFFFFFFFF};
  const std::string path = "to the waypoint/through the door/Drive";
  const float full = ui_.Width(path, style);
  EXPECT_EQ(ui_.CutStart(path, style, full + 1), path);
  const std::string cut = ui_.CutStart(path, style, full / 2);
  EXPECT_LE(ui_.Width(cut, style), full / 2);
  EXPECT_EQ(cut.substr(cut.size() - 5), "Drive");
  EXPECT_EQ(ui_.CutStart(path, style, 1), "");
}

TEST_F(UiTest, BreaksAParagraphIntoLines) {
  const TextStyle style{Face::kSans, 12, 0xFFFFFFFF};
  const std::string text = "a sentence that is somewhat longer than a line";
  const float full = ui_.Width(text, style);
  const float one = ui_.ParagraphHeight(text, style, full + 1);
  EXPECT_GT(one, 10);
  EXPECT_NEAR(ui_.ParagraphHeight(text, style, full * 0.75F), 2 * one, 1);
  EXPECT_GT(ui_.ParagraphHeight(text, style, 0), 2 * one) << "nowhere to put it, but no end either";
}

TEST(Ui, WritesDurationsAsPeopleReadThem) {
  EXPECT_EQ(DurationText(4.21), "4.2 s");
  EXPECT_EQ(DurationText(185), "3:05");
  EXPECT_EQ(DurationText(7800), "2:10:00");
  EXPECT_EQ(DurationText(-0.01), "0.0 s") << "of clocks that differ a little";
}

TEST(Ui, PrintsShortTimesWithoutAnExponent) {
  EXPECT_EQ(MillisecondsText(0.352), "0.35 ms");
  EXPECT_EQ(MillisecondsText(12.3), "12 ms");
  EXPECT_EQ(MillisecondsText(400.4), "400 ms");
  EXPECT_EQ(MillisecondsText(67600), "1:07");
}

TEST(Ui, HasADifferentGlyphForEveryStatus) {
  EXPECT_STREQ(GlyphOf(Status::kIdle), "");
  EXPECT_STRNE(GlyphOf(Status::kSuccess), GlyphOf(Status::kFailure));
  EXPECT_STRNE(GlyphOf(Status::kRunning), GlyphOf(Status::kSkipped));
}

}  // namespace
}  // namespace coppice::editor
