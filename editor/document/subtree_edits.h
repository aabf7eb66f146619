// Making a SubTree of a branch, and a branch of a SubTree, so that the robot does the same as
// before. Like tree_edits.h.
#ifndef COPPICE_EDITOR_DOCUMENT_SUBTREE_EDITS_H_
#define COPPICE_EDITOR_DOCUMENT_SUBTREE_EDITS_H_

#include <set>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "editor/document/draft.h"
#include "editor/document/node_rules.h"

namespace coppice::editor {

/// What the tree of a branch gets from those who use it.
struct CallersOfTree {
  std::set<std::string> ports;  ///< attributes of the <SubTree>s that stand for it
  bool autoremap = false;       ///< one of them hands on all keys
  bool none = true;             ///< only the application runs it, and sees its keys
};

/// The keys that must go through the border of the branch, in order of their first use: those that
/// the rest of the tree or its callers use as well, those that are only read inside, and, in a tree
/// that only the application runs, those that are only written: what else are they written for?
std::vector<std::string> KeysAcross(const Document& document, const NodeRules& rules,
                                    ElementIndex branch, const CallersOfTree& callers);

/// Makes the one selected node the root of a new tree `id` of the same file, behind its own, and
/// puts a SubTree with the keys that cross the border in its place.
Outcome ExtractSubTree(Draft& draft, const NodeRules& rules, const std::string& id,
                       const CallersOfTree& callers);

/// Puts the nodes of `tree`, a <BehaviorTree> of `from`, in the place of the selected SubTree. Keys
/// of the SubTree alone that are also keys around it get a name of their own.
Outcome InlineSubTree(Draft& draft, const NodeRules& rules, const Document& from,
                      ElementIndex tree);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_SUBTREE_EDITS_H_
