// The list of differences: of the shown tree and another version of it, or else of the shown run
// and another one. difference.next, difference.previous.
#ifndef COPPICE_EDITOR_COMMANDS_DIFFERENCE_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_DIFFERENCE_COMMANDS_H_

#include <cstddef>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

void AddDifferenceCommands(EditorState& state);

/// The comparison of the shown run; null: there is none.
const RunComparison* ShownRunComparison(const EditorState& state);

/// Goes to the node of a difference of that comparison, in the first tick in which it differs.
void ShowRunDifference(EditorState& state, std::size_t difference);

/// Goes to a node of the shown run, in that tick.
void GoToRunNode(EditorState& state, std::uint64_t tick, const std::string& path);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_DIFFERENCE_COMMANDS_H_
