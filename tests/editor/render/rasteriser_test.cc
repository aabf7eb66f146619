#include "editor/render/rasteriser.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace coppice::editor {
namespace {

// A draw list of plain triangles on a picture of 64 x 64.
class RasteriserTest : public testing::Test {
 protected:
  RasteriserTest() : list_(&shared_), image_(MakeImage(64, 64, kBlack)) {
    list_._ResetForNewFrame();
    list_.Flags = 0;  // no smoothed edges
    list_.PushClipRect({0, 0}, {64, 64});
  }
  void Paint() {
    ImDrawList* lists[] = {&list_};
    ImDrawData data;
    data.Valid = true;
    data.CmdLists = lists;
    data.CmdListsCount = 1;
    data.DisplaySize = {64, 64};
    Rasterise(data, {texture_, 2, 1}, image_);
  }
  int Count(std::uint32_t color) const {
    return static_cast<int>(std::count(image_.pixels.begin(), image_.pixels.end(), color));
  }

  static constexpr std::uint32_t kBlack = 0xFF000000;
  static constexpr std::uint32_t kWhite = 0xFFFFFFFF;
  const unsigned char texture_[2] = {255, 255};
  ImDrawListSharedData shared_;
  ImDrawList list_;
  Image image_;
};

TEST_F(RasteriserTest, FillsExactlyThePixelsOfABox) {
  list_.AddRectFilled({10, 20}, {30, 25}, kWhite);
  Paint();
  EXPECT_EQ(Count(kWhite), 100);
  EXPECT_EQ(image_.At(10, 20), kWhite);
  EXPECT_EQ(image_.At(29, 24), kWhite);
  EXPECT_EQ(image_.At(30, 24), kBlack);
}

TEST_F(RasteriserTest, ClipsToTheRectangleOfTheCommand) {
  list_.PushClipRect({0, 0}, {12, 64}, true);
  list_.AddRectFilled({10, 20}, {30, 25}, kWhite);
  list_.PopClipRect();
  Paint();
  EXPECT_EQ(Count(kWhite), 10);
}

TEST_F(RasteriserTest, ClipsToThePicture) {
  list_.PushClipRect({-100, -100}, {1000, 1000});
  list_.AddRectFilled({-50, -50}, {500, 500}, kWhite);
  list_.AddTriangleFilled({-500, 30}, {900, -40}, {900, 700}, kWhite);
  list_.PopClipRect();
  Paint();
  EXPECT_EQ(Count(kWhite), 64 * 64);
}

TEST_F(RasteriserTest, PaintsASharedEdgeOnce) {
  // A fan around a point: with half-transparent paint a pixel that is hit twice is too bright.
  std::mt19937 random(2);
  const ImVec2 center = {31.3F, 30.7F};
  std::vector<ImVec2> rim;
  for (int i = 0; i < 12; ++i) {
    const float angle = static_cast<float>(i) * 6.2831853F / 12;
    const float radius = 18 + static_cast<float>(random() % 8);
    rim.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
  }
  for (std::size_t i = 0; i < rim.size(); ++i) {
    list_.AddTriangleFilled(center, rim[i], rim[(i + 1) % rim.size()], 0x80FFFFFF);
  }
  Paint();
  const std::uint32_t once = image_.At(31, 30);
  EXPECT_EQ(Count(once) + Count(kBlack), 64 * 64);
  EXPECT_GT(Count(once), 900);
}

TEST_F(RasteriserTest, BlendsByAlpha) {
  list_.AddRectFilled({0, 0}, {64, 64}, 0x800000FF);
  Paint();
  EXPECT_EQ(image_.At(5, 5) & 0xFFU, 128U);
  EXPECT_EQ(image_.At(5, 5) & 0xFF00U, 0U);
}

TEST_F(RasteriserTest, RunsColoursAcrossATriangle) {
  list_.AddRectFilledMultiColor({0, 0}, {64, 64}, kBlack, kWhite, kWhite, kBlack);
  Paint();
  EXPECT_LT(image_.At(2, 32) & 0xFFU, 16U);
  EXPECT_NEAR(image_.At(32, 32) & 0xFFU, 128, 4);
  EXPECT_GT(image_.At(61, 32) & 0xFFU, 240U);
}

}  // namespace
}  // namespace coppice::editor
