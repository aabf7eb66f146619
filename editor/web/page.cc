#include "editor/web/page.h"

#include <emscripten/emscripten.h>
#include <emscripten/html5.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace coppice::editor {
namespace {

constexpr char kCanvas[] = "#canvas";
constexpr double kLongestPause = 3600;  // s; infinity is no Duration

}  // namespace

Page::Page(const Clock& clock) : clock_(clock), window_(1, 1) {
  if (!glfw_.good() || !window_.get()) {
    error_ = "this browser has no WebGL 2";
    return;
  }
  EditorOptions options;
  options.scale = static_cast<float>(std::clamp(emscripten_get_device_pixel_ratio(), 1.0, 3.0));
  options.date = [] { return static_cast<std::int64_t>(std::time(nullptr)); };
  options.recent_file = "/coppice/recent";
  options.backup_folder = "/coppice/backup";
  editor_ = std::make_unique<Editor>(std::move(options));
  error_ = editor_->error();
  if (!error_.empty()) return;
  renderer_ = std::make_unique<GlRenderer>(editor_->context());
  if (!renderer_->good()) error_ = "this browser has no WebGL 2";
}

void Page::Connect(const std::string& robot) {
  const Outcome connected = editor_->Connect(robot);
  if (!connected) editor_->state().Notify(connected.problem(), editor_->state().now, true);
  is_asked_ = true;
}

void Page::Open(const std::string& path) {
  editor_->Open(path);
  is_asked_ = true;
}

void Page::Run() {
  last_ = clock_.Now();
  emscripten_set_main_loop_arg(
      [](void* self) {
        auto& page = *static_cast<Page*>(self);
        page.FitCanvas();
        if (page.NeedsFrame()) page.DrawFrame();
      },
      this, 0, true);
}

bool Page::NeedsFrame() const {
  return is_asked_ || window_.NeedsFrame() || !editor_->IsUpToDate() || clock_.Now() >= next_;
}

// As many pixels as the screen has where the style sheet puts the canvas.
void Page::FitCanvas() {
  double across = 0;
  double down = 0;
  if (emscripten_get_element_css_size(kCanvas, &across, &down) != EMSCRIPTEN_RESULT_SUCCESS) return;
  const double ratio = emscripten_get_device_pixel_ratio();
  const int width = std::max(1, static_cast<int>(std::lround(across * ratio)));
  const int height = std::max(1, static_cast<int>(std::lround(down * ratio)));
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  glfwSetWindowSize(window_.get(), width, height);
  is_asked_ = true;
}

void Page::DrawFrame() {
  is_asked_ = false;
  const Time now = clock_.Now();
  const float dt = std::chrono::duration<float>(now - last_).count();
  last_ = now;
  editor_->Frame(window_.Take(dt));
  window_.Show(editor_->cursor());
  renderer_->Draw(editor_->draw_data());
  const std::chrono::duration<double> pause(std::min(editor_->NextFrameIn(), kLongestPause));
  next_ = now + std::chrono::duration_cast<Duration>(pause);
  EM_ASM({
    Module.onFrame();
    Module.keepSoon();
  });
}

}  // namespace coppice::editor
