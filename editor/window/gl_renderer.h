// Draws frames of the editor with OpenGL, by ImGui's renderer.
#ifndef COPPICE_EDITOR_WINDOW_GL_RENDERER_H_
#define COPPICE_EDITOR_WINDOW_GL_RENDERER_H_

struct ImDrawData;
struct ImGuiContext;

namespace coppice::editor {

class GlRenderer {
 public:
  /// In the editor's context; a context of OpenGL is current, here and below.
  explicit GlRenderer(ImGuiContext* context);
  ~GlRenderer();
  GlRenderer(const GlRenderer&) = delete;
  GlRenderer& operator=(const GlRenderer&) = delete;

  /// False if this OpenGL is too old.
  bool good() const { return good_; }
  void Draw(ImDrawData* data);

 private:
  static void TakeFonts(ImDrawData& data);

  bool good_ = false;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WINDOW_GL_RENDERER_H_
