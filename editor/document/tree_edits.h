// The named changes of trees, made of the edits of bt_core/model. Each works on the selection of a
// Draft, or refuses; afterwards the draft's selection is what the user goes on with. Elements that
// lie in other selected ones go with them.
//
//   Draft draft(document, selection);
//   if (const Outcome deleted = DeleteNodes(draft); !deleted) Say(deleted.problem());
//
// None of them touches a byte that it need not.
#ifndef COPPICE_EDITOR_DOCUMENT_TREE_EDITS_H_
#define COPPICE_EDITOR_DOCUMENT_TREE_EDITS_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/outcome.h"
#include "editor/document/draft.h"
#include "editor/document/node_rules.h"

namespace coppice::editor {

/// Puts the elements of `fragments` (one XML element each) into `parent` and selects them.
Outcome InsertNodes(Draft& draft, const NodeRules& rules, ElementIndex parent,
                    std::uint32_t position, const std::vector<std::string>& fragments);

/// Deletes the selection with all that is in it; selects the next sibling, else the one before,
/// else the parent.
Outcome DeleteNodes(Draft& draft);

/// Deletes the selected nodes and puts their children in their places.
Outcome DeleteKeepingChildren(Draft& draft, const NodeRules& rules);

/// Moves the selection by one place among its siblings: -1 or +1. What stands at the edge stays.
Outcome MoveAmongSiblings(Draft& draft, int by);

/// Out of the parent, behind it.
Outcome Promote(Draft& draft, const NodeRules& rules);

/// Into the sibling before, as its last child; if that takes none, into the one behind, as its
/// first.
Outcome Demote(Draft& draft, const NodeRules& rules);

/// Moves the selection into `parent`, at `position` among the children that it has now.
Outcome MoveInto(Draft& draft, const NodeRules& rules, ElementIndex parent, std::uint32_t position);

/// Puts a new element around the selection, which must be neighbours; selects it. `xml` is an
/// element without children: <Repeat num_cycles="3"/>.
Outcome Wrap(Draft& draft, const NodeRules& rules, std::string_view xml);

/// Makes the selected nodes nodes of another type. Name, guards, hooks and the ports that the new
/// type has as well stay; if the new type is not known, all do.
Outcome ChangeType(Draft& draft, const NodeRules& rules, std::string_view type);

/// The attributes that ChangeType would take away from the element.
std::vector<std::string> LostByChange(const Document& document, const NodeRules& rules,
                                      ElementIndex element, std::string_view type);

/// Disables the selection, or enables it if all of it is disabled. A disabled node has
/// _skipIf="true", so every engine skips it; one that has a _skipIf already gets
/// _skipIf="true || (...)". Enabling gives the same bytes as before.
Outcome ToggleDisabled(Draft& draft);
bool IsDisabled(const Document& document, ElementIndex element);

/// Gives the attribute a value. The name of a node that is made empty goes.
Outcome SetValue(Draft& draft, std::string_view attribute, std::string_view value);
Outcome ClearValue(Draft& draft, std::string_view attribute);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_TREE_EDITS_H_
