// Dear ImGui's own widgets in the editor's colours, and its keys in the editor's numbers.
#ifndef COPPICE_EDITOR_THEME_IMGUI_STYLE_H_
#define COPPICE_EDITOR_THEME_IMGUI_STYLE_H_

#include <imgui.h>

#include "editor/keys/keys.h"
#include "editor/theme/palette.h"

namespace coppice::editor {

/// For the current context.
void ApplyImGuiStyle(const Palette& palette, float scale);

void MapKeys(ImGuiIO& io);
void ApplyKey(ImGuiIO& io, const KeyEvent& event);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_THEME_IMGUI_STYLE_H_
