// Several Dear ImGui contexts in one program: each object makes its own current while it works.
#ifndef COPPICE_EDITOR_THEME_IMGUI_CONTEXT_H_
#define COPPICE_EDITOR_THEME_IMGUI_CONTEXT_H_

#include <imgui.h>

namespace coppice::editor {

/// Makes a context current until the end of the block.
class WithContext {
 public:
  explicit WithContext(ImGuiContext* context) : before_(ImGui::GetCurrentContext()) {
    ImGui::SetCurrentContext(context);
  }
  ~WithContext() { ImGui::SetCurrentContext(before_); }
  WithContext(const WithContext&) = delete;
  WithContext& operator=(const WithContext&) = delete;

 private:
  ImGuiContext* before_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_THEME_IMGUI_CONTEXT_H_
