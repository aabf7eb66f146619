#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <iostream>
#include <limits>
#include <memory>

#include "bt_core/base/read_file.h"
#include "bt_core/live/discovery/multicast_search.h"
#include "editor/app/run.h"
#include "editor/live/record_source.h"
#include "editor/theme/fonts.h"
#include "editor/theme/scale.h"
#include "editor/window/gl_renderer.h"
#include "editor/window/glfw_window.h"

namespace coppice::editor {
namespace {

constexpr double kLongestWait = 0.25;  // seconds; signals are looked at this often
constexpr int kNoDisplay = 2;

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

// A display that goes away, as at a logout, ends the program from within Xlib: then nothing is
// destroyed.
class KeptAtExit {
 public:
  explicit KeptAtExit(Editor& editor) {
    editor_ = &editor;
    std::atexit([] {
      if (editor_) editor_->KeepWork();
    });
  }
  ~KeptAtExit() { editor_ = nullptr; }
  KeptAtExit(const KeptAtExit&) = delete;
  KeptAtExit& operator=(const KeptAtExit&) = delete;

 private:
  static inline Editor* editor_ = nullptr;
};

float InBounds(float scale) { return std::clamp(scale, 1.0F, 3.0F); }

// Of the first one: where the window comes up, most times.
float ScaleOfScreen() {
  float across = 1;
  if (GLFWmonitor* const first = glfwGetPrimaryMonitor()) {
    glfwGetMonitorContentScale(first, &across, nullptr);
  }
  return InBounds(across);
}

class WindowLoop {
 public:
  WindowLoop(const Clock& clock, const EditOptions& options, GlfwWindow& window, Editor& editor,
             GlRenderer& renderer)
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
    return g_stop || editor_.wants_quit() ||
           (options_.run_for > 0 && Elapsed() >= options_.run_for);
  }

  // Seconds since the last time.
  float Lapse() {
    const Time now = clock_.Now();
    return std::chrono::duration<float>(now - std::exchange(last_, now)).count();
  }

  void DrawFrame() {
    for (const std::string& path : window_.TakeDropped()) editor_.Open(path);
    if (window_.TakeCloseRequest()) editor_.AskToQuit();
    editor_.Frame(window_.Take(Lapse()));
    window_.Show(editor_.cursor());
    window_.SetTitle(editor_.title());
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
    const Outcome written = WritePng(ReadBack(*editor_.draw_data()), options_.picture);
    if (written) return;
    std::cerr << "coppice-edit: " << written.problem() << "\n";
    good_ = false;
  }

  const Clock& clock_;
  const EditOptions& options_;
  GlfwWindow& window_;
  Editor& editor_;
  GlRenderer& renderer_;
  const Time start_;
  Time last_;
  double next_picture_ = 0;
  bool good_ = true;
};

// What is missing after all is baked when it is drawn. A pipe is left for who opens it: it can be
// read only once.
CharacterSet UnusualIn(const std::vector<std::string>& files) {
  constexpr std::size_t kLongest = std::size_t{8} << 20;  // larger ones are not what is shown first
  std::string texts;
  for (const std::string& file : files) {
    std::error_code error;
    if (IsRecordName(file) || !std::filesystem::is_regular_file(file, error)) continue;
    texts += ReadFile(file, kLongest).value_or("");
  }
  return UnusualCharacters(texts);
}

}  // namespace

int RunWindow(const Clock& clock, const EditOptions& options) {
  const Glfw glfw;
  if (!glfw.good()) {
    std::cerr << "coppice-edit: no display (" << Glfw::LastError()
              << "); use --headless, or run it under xvfb-run\n";
    return kNoDisplay;
  }
  EditorOptions editor_options = LoadSettings(options);
  // Both take long, and each has a core.
  auto fonts = std::async(
      std::launch::async,
      [scale = ShownScale(editor_options.settings.scale, ScaleOfScreen()), files = options.files] {
        return std::make_shared<const Fonts>(scale, UnusualIn(files));
      });
  GlfwWindow window(editor_options.settings.width, editor_options.settings.height);
  if (!window.get()) {
    std::cerr << "coppice-edit: no OpenGL window (" << Glfw::LastError()
              << "); use --headless, or run it under xvfb-run\n";
    return kNoDisplay;
  }
  editor_options.fonts = fonts.get();
  float across = 1;
  glfwGetWindowContentScale(window.get(), &across, nullptr);
  editor_options.scale = InBounds(across);
  editor_options.wake = [] { glfwPostEmptyEvent(); };
  editor_options.search = std::make_shared<MulticastSearch>(editor_options.wake);
  editor_options.get_clipboard = [&window]() -> std::string {
    const char* text = glfwGetClipboardString(window.get());
    return text ? text : "";
  };
  editor_options.set_clipboard = [&window](const std::string& text) {
    glfwSetClipboardString(window.get(), text.c_str());
  };
  const std::unique_ptr<Editor> editor = MakeEditor(options, std::move(editor_options));
  if (!editor) return kNoDisplay;
  const KeptAtExit kept(*editor);
  GlRenderer renderer(editor->context());
  if (!renderer.good()) {
    std::cerr << "coppice-edit: OpenGL 3.0 is needed; use --headless\n";
    return kNoDisplay;
  }
  return WindowLoop(clock, options, window, *editor, renderer).Run();
}

}  // namespace coppice::editor
