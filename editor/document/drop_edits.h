// What a drop on the canvas does beside moving (MoveInto of tree_edits.h). Each works on the
// selection of a Draft, returns why it refuses, or nothing, and selects what was dropped.
#ifndef COPPICE_EDITOR_DOCUMENT_DROP_EDITS_H_
#define COPPICE_EDITOR_DOCUMENT_DROP_EDITS_H_

#include <string>

#include "editor/document/draft.h"
#include "editor/document/node_rules.h"

namespace coppice::editor {

/// Puts copies of the selected nodes into `parent`, at `position` among its children.
std::string CopyInto(Draft& draft, const NodeRules& rules, ElementIndex parent,
                     std::uint32_t position);

/// The selected node, one, goes to the place of `inner`, and `inner` becomes its last child.
std::string PutAround(Draft& draft, const NodeRules& rules, ElementIndex inner);

/// The selected nodes go to the place of `old`, which is deleted with all that stays in it.
std::string TakePlaceOf(Draft& draft, const NodeRules& rules, ElementIndex old);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_DROP_EDITS_H_
