// Log-points and pinned lanes: what is watched of a run without stopping it.
#ifndef COPPICE_EDITOR_COMMANDS_LOG_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_LOG_COMMANDS_H_

#include <cstdint>
#include <functional>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// "run.log", "run.log_point", "run.pin".
void AddLogCommands(EditorState& state);

/// Asks for the text, the condition and the hit count of a log-point.
void AskForLogPoint(EditorState& state, std::uint32_t number);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_LOG_COMMANDS_H_
