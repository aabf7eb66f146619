// The files that are made of a run: a record of what was received, and the tree itself.
#ifndef COPPICE_EDITOR_COMMANDS_RUN_FILES_H_
#define COPPICE_EDITOR_COMMANDS_RUN_FILES_H_

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// "run.save", "run.save_tree": they ask for the path. For a record one is offered that is free,
/// named after the tree and when the run began: "Patrol_2026-11-23_21-30-05.coppice". A record is
/// never overwritten; a tree replaces a file if that was said and asked again, and is opened then.
void AddRunFileCommands(EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_RUN_FILES_H_
