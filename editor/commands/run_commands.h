// The commands of live and replay: the playhead, the debugger, faults. Their keys are their own
// while a run is shown.
#ifndef COPPICE_EDITOR_COMMANDS_RUN_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_RUN_COMMANDS_H_

#include <cstdint>
#include <functional>
#include <string>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// "run.back", "run.pause", "run.breakpoint", ...
void AddRunCommands(EditorState& state);

/// Path of the selected node as robots write it (Program::Path), in a run or in a file; empty if
/// nothing is selected.
std::string SelectedRunPath(EditorState& state);

/// Selects a node of the run in the shown tree.
void SelectRunNode(EditorState& state, NodeIndex node);

/// Asks for the condition and the hit count of a hook.
void AskForCondition(EditorState& state, std::uint32_t number);

/// Sets the fault on the selected node, or takes it away if the node has one.
void ToggleFault(EditorState& state, Hook fault, double now);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_RUN_COMMANDS_H_
