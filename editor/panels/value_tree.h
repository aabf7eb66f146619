// The rows of a JSON value below its key: "blackboard/value/PATH", of which only those in sight are
// drawn. A click opens or folds one.
#ifndef COPPICE_EDITOR_PANELS_VALUE_TREE_H_
#define COPPICE_EDITOR_PANELS_VALUE_TREE_H_

#include <string>

#include "editor/live/values/value_cache.h"
#include "editor/theme/ui.h"

namespace coppice::editor {

/// With words: the rows that have them. Nothing if the value cannot be opened.
void DrawValueTree(const Ui& ui, SlotView& view, const std::string& words);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_VALUE_TREE_H_
