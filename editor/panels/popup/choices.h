// What the command palette offers: commands, nodes of the shown tree, trees, robots.
#ifndef COPPICE_EDITOR_PANELS_POPUP_CHOICES_H_
#define COPPICE_EDITOR_PANELS_POPUP_CHOICES_H_

#include <string>
#include <vector>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// The best choices for what is typed, best first, at most `limit`; of those that fit alike, what
/// was chosen last.
std::vector<Choice> FindChoices(EditorState& state, const std::string& typed, double now,
                                std::size_t limit);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_POPUP_CHOICES_H_
