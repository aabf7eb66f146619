#include "editor/canvas/paint/shapes.h"

#include <gtest/gtest.h>

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
  float length = 0;
  for (const Outline& dash : DashesOf(RoundedBox({{0, 0}, {100, 100}}, 0), 10)) {
    for (std::size_t i = 1; i < dash.size(); ++i) {
      length += std::hypot(dash[i].x - dash[i - 1].x, dash[i].y - dash[i - 1].y);
    }
  }
  EXPECT_NEAR(length, 200, 1) << "perimeter 400, dashes as long as gaps";
}

}  // namespace
}  // namespace coppice::editor
