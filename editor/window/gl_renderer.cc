#include "editor/window/gl_renderer.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace coppice::editor {

GlRenderer::GlRenderer(ImGuiContext* context) {
  ImGui::SetCurrentContext(context);
  good_ = ImGui_ImplOpenGL3_Init();
  if (good_) ImGui_ImplOpenGL3_NewFrame();  // makes the font texture
}

GlRenderer::~GlRenderer() {
  if (good_) ImGui_ImplOpenGL3_Shutdown();
  ImGui::SetCurrentContext(nullptr);
}

void GlRenderer::Draw(ImDrawData* data) {
  glViewport(0, 0, static_cast<int>(data->DisplaySize.x), static_cast<int>(data->DisplaySize.y));
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(data);
}

}  // namespace coppice::editor
