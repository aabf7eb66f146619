#include "editor/theme/imgui_style.h"

namespace coppice::editor {

void ApplyImGuiStyle(const Palette& palette, float scale) {
  ImGuiStyle style;
  style.WindowRounding = 4;
  style.PopupRounding = 4;
  style.FrameRounding = 4;
  style.ScrollbarRounding = 4;
  style.ScrollbarSize = 9;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.ChildBorderSize = 0;
  style.FramePadding = {8, 5};
  style.ItemSpacing = {8, 5};
  style.WindowPadding = {8, 8};
  style.DisabledAlpha = 0.45F;
  style.ScaleAllSizes(scale);
  const auto set = [&](ImGuiCol slot, Color color) {
    style.Colors[slot] = ImGui::ColorConvertU32ToFloat4(color);
  };
  set(ImGuiCol_Text, palette.text);
  set(ImGuiCol_TextDisabled, palette.text_dim);
  set(ImGuiCol_WindowBg, palette.canvas);
  set(ImGuiCol_ChildBg, 0);
  set(ImGuiCol_PopupBg, palette.panel);
  set(ImGuiCol_Border, palette.border);
  set(ImGuiCol_FrameBg, palette.field);
  set(ImGuiCol_FrameBgHovered, palette.field);
  set(ImGuiCol_FrameBgActive, palette.field);
  set(ImGuiCol_Header, palette.row_selected);
  set(ImGuiCol_HeaderHovered, palette.row_selected);
  set(ImGuiCol_HeaderActive, palette.row_selected);
  set(ImGuiCol_Separator, palette.border);
  set(ImGuiCol_ScrollbarBg, 0);
  set(ImGuiCol_ScrollbarGrab, Fade(palette.text_dim, 0.35F));
  set(ImGuiCol_ScrollbarGrabHovered, Fade(palette.text_dim, 0.55F));
  set(ImGuiCol_ScrollbarGrabActive, Fade(palette.text_dim, 0.7F));
  set(ImGuiCol_TextSelectedBg, Fade(palette.accent, 0.4F));
  ImGui::GetStyle() = style;
}

void MapKeys(ImGuiIO& io) {
  constexpr struct {
    ImGuiKey theirs;
    Key ours;
  } kKeys[] = {{ImGuiKey_Tab, kKeyTab},
               {ImGuiKey_LeftArrow, kKeyLeft},
               {ImGuiKey_RightArrow, kKeyRight},
               {ImGuiKey_UpArrow, kKeyUp},
               {ImGuiKey_DownArrow, kKeyDown},
               {ImGuiKey_PageUp, kKeyPageUp},
               {ImGuiKey_PageDown, kKeyPageDown},
               {ImGuiKey_Home, kKeyHome},
               {ImGuiKey_End, kKeyEnd},
               {ImGuiKey_Insert, kKeyInsert},
               {ImGuiKey_Delete, kKeyDelete},
               {ImGuiKey_Backspace, kKeyBackspace},
               {ImGuiKey_Space, kKeySpace},
               {ImGuiKey_Enter, kKeyEnter},
               {ImGuiKey_Escape, kKeyEscape},
               {ImGuiKey_KeyPadEnter, kKeyKeypadEnter},
               {ImGuiKey_A, 'A'},
               {ImGuiKey_C, 'C'},
               {ImGuiKey_V, 'V'},
               {ImGuiKey_X, 'X'},
               {ImGuiKey_Y, 'Y'},
               {ImGuiKey_Z, 'Z'}};
  for (const auto& key : kKeys) io.KeyMap[key.theirs] = key.ours;
}

// The event that releases a modifier may still name it.
void ApplyKey(ImGuiIO& io, const KeyEvent& event) {
  constexpr int kModifiers[] = {kShift, kCtrl, kAlt, kSuper};
  int modifiers = event.modifiers;
  if (IsModifier(event.key)) {
    const int modifier = kModifiers[(event.key - kKeyLeftShift) % 4];
    modifiers = event.down ? modifiers | modifier : modifiers & ~modifier;
  }
  io.KeyCtrl = (modifiers & kCtrl) != 0;
  io.KeyShift = (modifiers & kShift) != 0;
  io.KeyAlt = (modifiers & kAlt) != 0;
  io.KeySuper = (modifiers & kSuper) != 0;
  if (event.key >= 0 && event.key < IM_ARRAYSIZE(io.KeysDown)) io.KeysDown[event.key] = event.down;
}

}  // namespace coppice::editor
