#include <algorithm>
#include <iostream>

#include "bt_core/base/wake_up.h"
#include "editor/app/run.h"

namespace coppice::editor {
namespace {

constexpr float kFrameSeconds = 0.05F;

bool Save(const Editor& editor, const std::string& path) {
  const Outcome written = WritePng(editor.Picture(), path);
  if (!written) std::cerr << "coppice-edit: " << written.problem() << "\n";
  return written.ok();
}

}  // namespace

int RunHeadless(Clock& clock, const EditOptions& options) {
  const EditorOptions editor_options = LoadSettings(options);
  const std::unique_ptr<Editor> editor = MakeEditor(options, editor_options);
  if (!editor) return 2;
  const auto seconds = [&clock](Time since) {
    return std::chrono::duration<double>(clock.Now() - since).count();
  };
  const Time start = clock.Now();
  double next_picture = options.picture_every;
  InputEvents input;
  input.width = static_cast<float>(editor_options.settings.width);
  input.height = static_cast<float>(editor_options.settings.height);
  input.dt = kFrameSeconds;
  WakeUp wake_up;  // nobody notifies it: the loop looks at the flag at every frame
  bool good = true;
  // Without robots nothing changes: a few frames show all there is.
  const bool endless = options.run_for > 0 || !options.robots.empty();
  for (int frame = 0; !g_stop && (endless || frame < 4); ++frame) {
    editor->Frame(input);
    const double elapsed = seconds(start);
    if (!options.picture.empty() && options.picture_every > 0 && elapsed >= next_picture) {
      good = Save(*editor, options.picture) && good;
      next_picture = elapsed + options.picture_every;
    }
    if (options.run_for > 0 && elapsed >= options.run_for) break;
    if (endless) {
      clock.WaitUntil(clock.Now() + std::chrono::milliseconds(50), wake_up);
    }
  }
  if (!options.picture.empty()) good = Save(*editor, options.picture) && good;
  return good ? 0 : 1;
}

}  // namespace coppice::editor
