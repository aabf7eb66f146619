// Outlines that Dear ImGui does not have: dashed lines, cut corners, hatching.
#ifndef COPPICE_EDITOR_CANVAS_SHAPES_H_
#define COPPICE_EDITOR_CANVAS_SHAPES_H_

#include <imgui.h>

#include <vector>

#include "editor/canvas/geometry.h"
#include "editor/look/palette.h"

namespace coppice::editor {

/// A closed outline, clockwise from the upper left.
using Outline = std::vector<ImVec2>;

Outline RoundedBox(const Box& box, float radius);
Outline CutBox(const Box& box, float cut);

void FillOutline(ImDrawList& list, const Outline& outline, Color color);
void StrokeOutline(ImDrawList& list, const Outline& outline, Color color, float thickness);

/// Dashes and gaps of that length, running around the outline.
void DashOutline(ImDrawList& list, const Outline& outline, Color color, float thickness,
                 float dash);

/// Slanted lines inside the box.
void Hatch(ImDrawList& list, const Box& box, Color color, float distance);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_SHAPES_H_
