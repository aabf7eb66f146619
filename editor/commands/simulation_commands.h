// The commands about simulations and tests.
#ifndef COPPICE_EDITOR_COMMANDS_SIMULATION_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_SIMULATION_COMMANDS_H_

#include <functional>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Adds them to state.commands, behind all others: while a simulation is shown their keys count.
/// `state` must outlive them.
void AddSimulationCommands(EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_SIMULATION_COMMANDS_H_
