// A window of GLFW whose events are those of the editor.
#ifndef COPPICE_EDITOR_WINDOW_GLFW_WINDOW_H_
#define COPPICE_EDITOR_WINDOW_GLFW_WINDOW_H_

#include <GLFW/glfw3.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "editor/keys/input_queue.h"

namespace coppice::editor {

/// The library, from construction to destruction.
class Glfw {
 public:
  Glfw();
  ~Glfw();
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;

  bool good() const { return good_; }
  /// What went wrong last, in the words of the library.
  static const std::string& LastError();

 private:
  bool good_ = false;
};

class GlfwWindow {
 public:
  /// With a context of OpenGL, which is made current.
  GlfwWindow(int width, int height);
  ~GlfwWindow();
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  /// Null if there is no window.
  GLFWwindow* get() const { return window_; }
  void Show(CursorShape shape);

  /// What happened since the last call, and the size now. `dt`: seconds since then.
  InputEvents Take(float dt);
  bool NeedsFrame() const {
    return !events_.empty() || damaged_ || !dropped_.empty() || is_asked_to_close_;
  }
  /// Whether the user closed it since the last call; it stays open until its end.
  bool TakeCloseRequest() { return std::exchange(is_asked_to_close_, false); }
  void SetTitle(const std::string& title);
  /// Files that were dragged onto the window since the last call.
  std::vector<std::string> TakeDropped() { return std::exchange(dropped_, {}); }

 private:
  static GlfwWindow& Self(GLFWwindow* window);
  void SetCallbacks();

  GLFWwindow* window_ = nullptr;
  std::array<GLFWcursor*, 5> cursors_{};  // by CursorShape
  std::vector<InputEvent> events_;
  bool damaged_ = true;
  bool is_asked_to_close_ = false;
  std::string title_;
  std::vector<std::string> dropped_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WINDOW_GLFW_WINDOW_H_
