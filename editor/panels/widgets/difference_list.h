// The differences of two versions of a tree, a sentence each; a click goes to the node.
// "comparison/difference/0".
#ifndef COPPICE_EDITOR_PANELS_WIDGETS_DIFFERENCE_LIST_H_
#define COPPICE_EDITOR_PANELS_WIDGETS_DIFFERENCE_LIST_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Two buttons that go to the previous and the next difference, in a row of that height whose right
/// end is `right_top`. "comparison/previous", "comparison/next". Returns their left end.
float DrawDifferenceButtons(const Ui& ui, EditorState& state, Point right_top, float height);

void DrawDifferenceList(const Ui& ui, EditorState& state, Comparison& comparison, const Box& box);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_WIDGETS_DIFFERENCE_LIST_H_
