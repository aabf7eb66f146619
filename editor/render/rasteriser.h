// Paints what Dear ImGui wants drawn into a picture, without a display and without OpenGL.
//
// The result depends on the draw data alone: positions are rounded to 1/256 pixel and coverage is
// computed in whole numbers (edge functions with the top-left rule; J. Pineda, "A parallel
// algorithm for polygon rasterization", SIGGRAPH 1988), so two runs give the same bits.
#ifndef COPPICE_EDITOR_RENDER_RASTERISER_H_
#define COPPICE_EDITOR_RENDER_RASTERISER_H_

#include <imgui.h>

#include "editor/render/image.h"

namespace coppice::editor {

/// The alpha texture of the font atlas.
struct Texture {
  const unsigned char* alpha = nullptr;
  int width = 0;
  int height = 0;
};

/// Paints over `image`, whose upper left corner is the display's.
void Rasterise(const ImDrawData& data, const Texture& texture, Image& image);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_RENDER_RASTERISER_H_
