#include "editor/canvas/shapes.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <cmath>

namespace coppice::editor {
namespace {

Box Around(const Outline& outline) {
  Box box = {{outline[0].x, outline[0].y}, {outline[0].x, outline[0].y}};
  for (const ImVec2& p : outline) box = Union(box, {{p.x, p.y}, {p.x, p.y}});
  return box;
}

TEST(Shapes, KeepOutlinesInsideTheirBox) {
  const Box box = {{10, 20}, {110, 50}};
  for (const Outline& outline : {RoundedBox(box, 8), RoundedBox(box, 100), CutBox(box, 6)}) {
    const Box around = Around(outline);
    EXPECT_NEAR(around.min.x, 10, 0.01);
    EXPECT_NEAR(around.max.x, 110, 0.01);
    EXPECT_NEAR(around.min.y, 20, 0.01);
    EXPECT_NEAR(around.max.y, 50, 0.01);
  }
  EXPECT_EQ(CutBox(box, 6).size(), 8U);
  EXPECT_EQ(RoundedBox(box, 0).size(), 4U);
}

TEST(Shapes, DrawHalfOfADashedOutline) {
  ImDrawListSharedData shared;
  ImDrawList list(&shared);
  list._ResetForNewFrame();
  DashOutline(list, RoundedBox({{0, 0}, {100, 100}}, 0), 0xFFFFFFFF, 2, 10);
  float length = 0;  // of the long sides of the dashes
  for (int i = 0; i + 3 < list.VtxBuffer.Size; i += 4) {
    const ImVec2 a = list.VtxBuffer[i].pos;
    const ImVec2 b = list.VtxBuffer[i + 1].pos;
    length += std::hypot(b.x - a.x, b.y - a.y);
  }
  EXPECT_NEAR(length, 200, 25) << "perimeter 400, dashes as long as gaps";
}

}  // namespace
}  // namespace coppice::editor
