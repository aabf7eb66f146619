// Outlines that Dear ImGui does not have: dashed lines, cut corners.
#ifndef COPPICE_EDITOR_CANVAS_PAINT_SHAPES_H_
#define COPPICE_EDITOR_CANVAS_PAINT_SHAPES_H_

#include <imgui.h>

#include <vector>

#include "editor/theme/geometry.h"

namespace coppice::editor {

/// A closed outline, clockwise from the upper left; or the points of an open line.
using Outline = std::vector<ImVec2>;

Outline RoundedBox(const Box& box, float radius);
Outline CutBox(const Box& box, float cut);

/// Lines of that length with gaps of the same length, running around the outline.
std::vector<Outline> DashesOf(const Outline& outline, float dash);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_PAINT_SHAPES_H_
