// The editor in a web page: one canvas, drawn when the browser asks for a picture and there is
// something new. It follows the robot that the page came from.
//
//   Page page(clock);
//   page.Open("/trees/patrol.xml");       // put there by the script of the page
//   page.Run();                           // does not return
#ifndef COPPICE_EDITOR_WEB_PAGE_H_
#define COPPICE_EDITOR_WEB_PAGE_H_

#include <memory>
#include <string>

#include "editor/shell/editor.h"
#include "editor/window/gl_renderer.h"
#include "editor/window/glfw_window.h"

namespace coppice::editor {

class Page {
 public:
  explicit Page(const Clock& clock);

  /// Why there is nothing to see; empty if there is.
  const std::string& error() const { return error_; }
  /// "host:port".
  void Connect(const std::string& robot);
  void Open(const std::string& path);
  /// Draws, whenever the browser wants a picture, for as long as the page is there.
  void Run();

 private:
  bool NeedsFrame() const;
  void FitCanvas();
  void DrawFrame();

  const Clock& clock_;
  const Glfw glfw_;
  GlfwWindow window_;
  std::unique_ptr<Editor> editor_;
  std::unique_ptr<GlRenderer> renderer_;
  std::string error_;
  Time last_{};    // when the last frame was drawn
  Time next_{};    // when the next one is due
  int width_ = 0;  // of the canvas, in its pixels
  int height_ = 0;
  bool is_asked_ = true;  // for a frame, by something outside it
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WEB_PAGE_H_
