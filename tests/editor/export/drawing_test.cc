#include "editor/export/drawing.h"

#include <gtest/gtest.h>

#include "editor/theme/imgui_context.h"
#include "tests/editor/shared_fonts.h"

namespace coppice::editor {
namespace {

class DrawingTest : public testing::Test {
 protected:
  DrawingTest() : current_(context_) {}
  ~DrawingTest() override { ImGui::DestroyContext(context_); }

  const std::shared_ptr<const Fonts> fonts_ = SharedFonts(1);
  ImGuiContext* const context_ = fonts_->MakeContext();
  const WithContext current_;
  ItemRegistry items_;
  const Ui ui_{GetPalette(PaletteName::kDark), *fonts_, items_, 1, 0, Time{}};
  Drawing drawing_;
  DrawingPen pen_{ui_, drawing_};
};

TEST_F(DrawingTest, KeepsWhatIsDrawnInItsOrder) {
  pen_.FillBox({{1, 2}, {3, 4}}, 0xFF112233, 5);
  pen_.Disc({6, 7}, 8, 0xFF445566);
  ASSERT_EQ(drawing_.items.size(), 2U);
  EXPECT_EQ(drawing_.items[0].kind, DrawnItem::Kind::kBox);
  EXPECT_EQ(drawing_.items[0].points, (std::vector<Point>{{1, 2}, {3, 4}}));
  EXPECT_EQ(drawing_.items[0].size, 5);
  EXPECT_EQ(drawing_.items[1].color, 0xFF445566);
}

TEST_F(DrawingTest, KeepsTextsWithWidthAndBaseLine) {
  pen_.Text({10, 20}, "goal", {Face::kMono, 12, 0xFFFFFFFF});
  ASSERT_EQ(drawing_.items.size(), 1U);
  const DrawnItem& item = drawing_.items[0];
  EXPECT_EQ(item.text, "goal");
  EXPECT_EQ(item.face, Face::kMono);
  EXPECT_NEAR(item.width, ui_.Width("goal", {Face::kMono, 12, 0}), 0.01);
  EXPECT_GT(item.points[0].y, 28);  // below the upper edge of the row
  EXPECT_LT(item.points[0].y, 33);
}

TEST_F(DrawingTest, OpacityThinsTheInk) {
  pen_.opacity = 0.5F;
  pen_.Disc({0, 0}, 1, 0xFF000000);
  EXPECT_NEAR(static_cast<double>(drawing_.items[0].color >> 24), 127, 1);
}

TEST_F(DrawingTest, DashesBecomeLines) {
  pen_.Dash({{0, 0}, {100, 0}, {100, 100}}, 0xFFFFFFFF, 1, 5);
  EXPECT_GT(drawing_.items.size(), 20U);
  EXPECT_EQ(drawing_.items[0].kind, DrawnItem::Kind::kLine);
}

}  // namespace
}  // namespace coppice::editor
