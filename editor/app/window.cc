// The only translation unit that knows GLFW and OpenGL.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>

#include "editor/app/run.h"

namespace coppice::editor {
namespace {

constexpr double kLongestWait = 0.25;  // seconds; signals are looked at this often
constexpr int kNoDisplay = 2;

// The library, from construction to destruction.
class Glfw {
 public:
  Glfw() {
    glfwSetErrorCallback([](int, const char* text) { LastError() = text; });
    good_ = glfwInit() == GLFW_TRUE;
  }
  ~Glfw() {
    if (good_) glfwTerminate();
  }
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;

  bool good() const { return good_; }
  static std::string& LastError() {
    static std::string text;
    return text;
  }

 private:
  bool good_ = false;
};

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

class Window {
 public:
  explicit Window(const EditOptions& options) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    window_ = glfwCreateWindow(options.width, options.height, "Coppice", nullptr, nullptr);
    if (!window_) return;
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(window_, this);
    SetCallbacks();
    constexpr std::array<int, 5> kShapes = {GLFW_ARROW_CURSOR, GLFW_IBEAM_CURSOR,
                                            GLFW_HRESIZE_CURSOR, GLFW_VRESIZE_CURSOR,
                                            GLFW_HAND_CURSOR};
    for (std::size_t i = 0; i < kShapes.size(); ++i) {
      cursors_[i] = glfwCreateStandardCursor(kShapes[i]);
    }
  }
  ~Window() {
    for (GLFWcursor* cursor : cursors_) {
      if (cursor) glfwDestroyCursor(cursor);
    }
    if (window_) glfwDestroyWindow(window_);
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* get() const { return window_; }
  void Show(CursorShape shape) {
    glfwSetCursor(window_, cursors_[static_cast<std::size_t>(shape)]);
  }

  /// What happened since the last call, and the size now.
  InputEvents Take(float dt) {
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
  bool NeedsFrame() const { return !events_.empty() || damaged_; }

 private:
  static Window& Self(GLFWwindow* window) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
  }

  void SetCallbacks() {
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
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned codepoint) {
      Self(w).events_.push_back(TypedText{ToUtf8(codepoint)});
    });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { Self(w).damaged_ = true; });
    glfwSetFramebufferSizeCallback(window_,
                                   [](GLFWwindow* w, int, int) { Self(w).damaged_ = true; });
  }

  GLFWwindow* window_ = nullptr;
  std::array<GLFWcursor*, 5> cursors_{};
  std::vector<InputEvent> events_;
  bool damaged_ = true;
};

// ImGui's OpenGL renderer, in the editor's context.
class Renderer {
 public:
  explicit Renderer(ImGuiContext* context) {
    ImGui::SetCurrentContext(context);
    good_ = ImGui_ImplOpenGL3_Init("#version 130");
    if (good_) ImGui_ImplOpenGL3_NewFrame();  // makes the font texture
  }
  ~Renderer() {
    if (good_) ImGui_ImplOpenGL3_Shutdown();
    ImGui::SetCurrentContext(nullptr);
  }
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  bool good() const { return good_; }
  void Draw(ImDrawData* data) {
    glViewport(0, 0, static_cast<int>(data->DisplaySize.x), static_cast<int>(data->DisplaySize.y));
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(data);
  }

 private:
  bool good_ = false;
};

// What the window shows, read back from OpenGL, which begins at the lower left.
Image ReadBack(const ImDrawData& data) {
  Image image =
      MakeImage(static_cast<int>(data.DisplaySize.x), static_cast<int>(data.DisplaySize.y), 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
  const auto width = static_cast<std::size_t>(image.width);
  for (std::size_t top = 0, bottom = static_cast<std::size_t>(image.height); top + 1 < bottom;
       ++top) {
    --bottom;
    std::swap_ranges(image.pixels.begin() + static_cast<std::ptrdiff_t>(top * width),
                     image.pixels.begin() + static_cast<std::ptrdiff_t>((top + 1) * width),
                     image.pixels.begin() + static_cast<std::ptrdiff_t>(bottom * width));
  }
  return image;
}

class WindowLoop {
 public:
  WindowLoop(const Clock& clock, const EditOptions& options, Window& window, Editor& editor,
             Renderer& renderer)
      : clock_(clock),
        options_(options),
        window_(window),
        editor_(editor),
        renderer_(renderer),
        start_(clock.Now()),
        last_(start_) {}

  int Run() {
    next_picture_ = options_.picture_every;
    while (!Ended()) {
      DrawFrame();
      Wait();
    }
    if (!options_.picture.empty()) {
      RedrawBackBuffer();
      Save();
    }
    return good_ ? 0 : 1;
  }

 private:
  double Elapsed() const { return std::chrono::duration<double>(clock_.Now() - start_).count(); }

  bool Ended() const {
    return g_stop || editor_.wants_quit() || glfwWindowShouldClose(window_.get()) ||
           (options_.run_for > 0 && Elapsed() >= options_.run_for);
  }

  // Seconds since the last time.
  float Lapse() {
    const Time now = clock_.Now();
    return std::chrono::duration<float>(now - std::exchange(last_, now)).count();
  }

  void DrawFrame() {
    editor_.Frame(window_.Take(Lapse()));
    window_.Show(editor_.cursor());
    RedrawBackBuffer();
    if (!options_.picture.empty() && options_.picture_every > 0 && Elapsed() >= next_picture_) {
      Save();
      next_picture_ = Elapsed() + options_.picture_every;
    }
    glfwSwapBuffers(window_.get());
  }

  void RedrawBackBuffer() { renderer_.Draw(editor_.draw_data()); }

  // Until something happens or the editor wants to move on. Robots wake the loop through
  // glfwPostEmptyEvent; more than one frame per period of theirs is not worth drawing.
  void Wait() {
    double frame_at = Elapsed() + editor_.NextFrameIn();
    glfwPollEvents();
    while (!Ended() && !window_.NeedsFrame()) {
      double left = frame_at - Elapsed();
      if (options_.picture_every > 0) left = std::min(left, next_picture_ - Elapsed());
      if (left <= 0) {
        if (options_.picture_every > 0 || editor_.Rest(Lapse())) return;
        frame_at = Elapsed() + editor_.NextFrameIn();
        continue;
      }
      if (options_.run_for > 0) left = std::min(left, options_.run_for - Elapsed());
      glfwWaitEventsTimeout(std::clamp(left, 0.001, kLongestWait));
      // While live, statuses come faster than they are drawn; otherwise any news is drawn at once.
      if (!editor_.IsUpToDate() && left > 0.1) return;
    }
  }

  void Save() {
    const std::string wrong = WritePng(ReadBack(*editor_.draw_data()), options_.picture);
    if (wrong.empty()) return;
    std::cerr << "coppice-edit: " << wrong << "\n";
    good_ = false;
  }

  const Clock& clock_;
  const EditOptions& options_;
  Window& window_;
  Editor& editor_;
  Renderer& renderer_;
  const Time start_;
  Time last_;
  double next_picture_ = 0;
  bool good_ = true;
};

}  // namespace

int RunWindow(const Clock& clock, const EditOptions& options) {
  const Glfw glfw;
  if (!glfw.good()) {
    std::cerr << "coppice-edit: no display (" << Glfw::LastError()
              << "); use --headless, or run it under xvfb-run\n";
    return kNoDisplay;
  }
  Window window(options);
  if (!window.get()) {
    std::cerr << "coppice-edit: no OpenGL window (" << Glfw::LastError()
              << "); use --headless, or run it under xvfb-run\n";
    return kNoDisplay;
  }
  EditorOptions editor_options;
  float across = 1;
  float down = 1;
  glfwGetWindowContentScale(window.get(), &across, &down);
  editor_options.scale = std::clamp(across, 1.0F, 3.0F);
  editor_options.wake = [] { glfwPostEmptyEvent(); };
  editor_options.get_clipboard = [&window]() -> std::string {
    const char* text = glfwGetClipboardString(window.get());
    return text ? text : "";
  };
  editor_options.set_clipboard = [&window](const std::string& text) {
    glfwSetClipboardString(window.get(), text.c_str());
  };
  const std::unique_ptr<Editor> editor = MakeEditor(options, std::move(editor_options));
  if (!editor) return kNoDisplay;
  Renderer renderer(editor->context());
  if (!renderer.good()) {
    std::cerr << "coppice-edit: OpenGL 3.0 is needed; use --headless\n";
    return kNoDisplay;
  }
  return WindowLoop(clock, options, window, *editor, renderer).Run();
}

}  // namespace coppice::editor
