// What the tabs of the run's tile show. There is a tree and at least one tick.
#ifndef COPPICE_EDITOR_PANELS_RUN_RUN_BODIES_H_
#define COPPICE_EDITOR_PANELS_RUN_RUN_BODIES_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// The walk of the shown tick on the way to the selected node. "run/why/0", "run/why/change".
void DrawWhy(const Ui& ui, EditorState& state, RunView& run);

/// All robots, those that need somebody first, with the reason. "run/robots/ENDPOINT".
void DrawRobots(const Ui& ui, EditorState& state, RunView& run);

/// The leaves that run, the longest first. "run/running/PATH".
void DrawRunning(const Ui& ui, EditorState& state, RunView& run);

/// Breakpoints and faults of all robots. "run/hook/1", with "/on" and "/remove".
void DrawHooks(const Ui& ui, EditorState& state, RunView& run);

/// Log-points and the lines that they have written, the newest first. "run/log/0",
/// "run/log/point/1" with "/text", "/on" and "/remove".
void DrawLog(const Ui& ui, EditorState& state, RunView& run);

/// Figures of every node, of the marked stretch or of the whole run. "run/figures/PATH".
void DrawStatistics(const Ui& ui, EditorState& state, RunView& run);

/// Where this run and another one part. "run/compare/NAME", "run/parting", "run/difference/0".
void DrawComparison(const Ui& ui, EditorState& state, RunView& run);

/// What the robot shows to people now: its face, say. "run/pictures/NAME".
void DrawPictures(const Ui& ui, EditorState& state, RunView& run);

/// What the runs by chance have reached, and what they have not. "run/coverage/never_ticked/PATH",
/// "run/coverage/finding/0".
void DrawCoverage(const Ui& ui, EditorState& state, RunView& run);

/// The value of the shown key as a table, if it is a list of objects: the processes of the robot,
/// or whatever the application has. "run/table/0", "run/table/sort/COLUMN",
/// "run/table/key/SCOPE/KEY".
void DrawTable(const Ui& ui, EditorState& state, RunView& run);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_RUN_RUN_BODIES_H_
