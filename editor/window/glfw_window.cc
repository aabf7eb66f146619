#include "editor/window/glfw_window.h"

#include <algorithm>

namespace coppice::editor {
namespace {

std::string& Error() {
  static std::string text;
  return text;
}

std::string ToUtf8(unsigned codepoint) {
  std::string text;
  const auto add = [&text](unsigned byte) { text += static_cast<char>(byte); };
  if (codepoint < 0x80) {
    add(codepoint);
  } else if (codepoint < 0x800) {
    add(0xC0 | (codepoint >> 6));
    add(0x80 | (codepoint & 0x3F));
  } else if (codepoint < 0x10000) {
    add(0xE0 | (codepoint >> 12));
    add(0x80 | ((codepoint >> 6) & 0x3F));
    add(0x80 | (codepoint & 0x3F));
  } else {
    add(0xF0 | (codepoint >> 18));
    add(0x80 | ((codepoint >> 12) & 0x3F));
    add(0x80 | ((codepoint >> 6) & 0x3F));
    add(0x80 | (codepoint & 0x3F));
  }
  return text;
}

}  // namespace

Glfw::Glfw() {
  glfwSetErrorCallback([](int, const char* text) { Error() = text; });
  good_ = glfwInit() == GLFW_TRUE;
}

Glfw::~Glfw() {
  if (good_) glfwTerminate();
}

const std::string& Glfw::LastError() { return Error(); }

GlfwWindow::GlfwWindow(int width, int height) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
  window_ = glfwCreateWindow(width, height, "Coppice", nullptr, nullptr);
  if (!window_) return;
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  SetCallbacks();
  constexpr std::array<int, 5> kShapes = {GLFW_ARROW_CURSOR, GLFW_IBEAM_CURSOR, GLFW_HRESIZE_CURSOR,
                                          GLFW_VRESIZE_CURSOR, GLFW_HAND_CURSOR};
  for (std::size_t i = 0; i < kShapes.size(); ++i) {
    cursors_[i] = glfwCreateStandardCursor(kShapes[i]);
  }
}

GlfwWindow::~GlfwWindow() {
  for (GLFWcursor* cursor : cursors_) {
    if (cursor) glfwDestroyCursor(cursor);
  }
  if (window_) glfwDestroyWindow(window_);
}

void GlfwWindow::Show(CursorShape shape) {
  glfwSetCursor(window_, cursors_[static_cast<std::size_t>(shape)]);
}

void GlfwWindow::SetTitle(const std::string& title) {
  if (title == title_) return;
  title_ = title;
  glfwSetWindowTitle(window_, title.c_str());
}

InputEvents GlfwWindow::Take(float dt) {
  InputEvents input;
  input.events.swap(events_);
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  input.width = static_cast<float>(std::max(width, 1));
  input.height = static_cast<float>(std::max(height, 1));
  input.dt = dt;
  damaged_ = false;
  return input;
}

GlfwWindow& GlfwWindow::Self(GLFWwindow* window) {
  return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
}

void GlfwWindow::SetCallbacks() {
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    Self(w).events_.push_back(MouseMove{static_cast<float>(x), static_cast<float>(y)});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
    Self(w).events_.push_back(MouseButton{button, action == GLFW_PRESS});
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
    Self(w).events_.push_back(MouseWheel{static_cast<float>(x), static_cast<float>(y)});
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int modifiers) {
    constexpr int kKnown = GLFW_MOD_SHIFT | GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
    Self(w).events_.push_back(KeyEvent{key, action != GLFW_RELEASE, modifiers & kKnown});
  });
  // Keys that are held are let go then, as if the user did it: a key without a name says otherwise.
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
    if (!focused) Self(w).events_.push_back(KeyEvent{});
  });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    Self(w).dropped_.assign(paths, paths + count);
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned codepoint) {
    Self(w).events_.push_back(TypedText{ToUtf8(codepoint)});
  });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) {
    Self(w).is_asked_to_close_ = true;
    glfwSetWindowShouldClose(w, GLFW_FALSE);
  });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { Self(w).damaged_ = true; });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { Self(w).damaged_ = true; });
}

}  // namespace coppice::editor
