// The two ways to run an Editor: in a window, and without a display.
#ifndef COPPICE_EDITOR_APP_RUN_H_
#define COPPICE_EDITOR_APP_RUN_H_

#include <atomic>
#include <functional>
#include <memory>

#include "bt_core/base/clock.h"
#include "editor/app/edit_options.h"
#include "editor/shell/editor.h"

namespace coppice::editor {

/// Set by SIGTERM and SIGINT.
extern std::atomic<bool> g_stop;

/// What the user chose the last time, as kept_settings, and the same changed as the command line
/// says. Prints what is wrong with it.
EditorOptions LoadSettings(const EditOptions& options);

/// Fills an editor as the command line says. Prints what is wrong; null if it cannot run.
std::unique_ptr<Editor> MakeEditor(const EditOptions& options, EditorOptions editor_options);

/// Both return the program's exit code.
int RunWindow(const Clock& clock, const EditOptions& options);
int RunHeadless(Clock& clock, const EditOptions& options);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_APP_RUN_H_
