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

// All that is drawn has the one texture of the fonts. Other fonts come without one; the frame that
// is drawn first with them was made before theirs.
void GlRenderer::TakeFonts(ImDrawData& data) {
  if (ImGui::GetIO().Fonts->TexID) return;
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  for (int i = 0; i < data.CmdListsCount; ++i) {
    for (ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) {
      command.TextureId = ImGui::GetIO().Fonts->TexID;
    }
  }
}

void GlRenderer::Draw(ImDrawData* data) {
  TakeFonts(*data);
  glViewport(0, 0, static_cast<int>(data->DisplaySize.x), static_cast<int>(data->DisplaySize.y));
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(data);
}

}  // namespace coppice::editor
