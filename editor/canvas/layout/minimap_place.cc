#include "editor/canvas/layout/minimap_place.h"

namespace coppice::editor {

Box InCorner(Corner corner, const Box& canvas, Point size, float margin) {
  const bool is_right = corner == Corner::kUpperRight || corner == Corner::kLowerRight;
  const bool is_upper = corner == Corner::kUpperRight || corner == Corner::kUpperLeft;
  const Point min = {is_right ? canvas.max.x - margin - size.x : canvas.min.x + margin,
                     is_upper ? canvas.min.y + margin : canvas.max.y - margin - size.y};
  return {min, min + size};
}

CornerChoice FreestCorner(const Box& canvas, Point size, float margin,
                          const std::vector<Box>& nodes, Corner present) {
  const auto hidden_in = [&](Corner corner) {
    const Box box = InCorner(corner, canvas, size, margin);
    float hidden = 0;
    for (const Box& node : nodes) hidden += CommonArea(box, node);
    return hidden;
  };
  Corner best = present;
  float least = hidden_in(present);
  for (const Corner corner :
       {Corner::kUpperRight, Corner::kLowerRight, Corner::kLowerLeft, Corner::kUpperLeft}) {
    const float hidden = least > 0 ? hidden_in(corner) : least;
    if (hidden >= least) continue;
    best = corner;
    least = hidden;
  }
  return {best, least <= 0};
}

}  // namespace coppice::editor
