// What it means to let nodes go somewhere over a tree: between others, onto one, or onto the line
// above one. Like tree_edits.h; each selects what was dropped.
#ifndef COPPICE_EDITOR_DOCUMENT_DROP_EDITS_H_
#define COPPICE_EDITOR_DOCUMENT_DROP_EDITS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "editor/document/draft.h"
#include "editor/document/node_rules.h"

namespace coppice::editor {

struct DropSpot {
  enum class Kind : std::uint8_t {
    kInto,     ///< among the children of `element`, at `position`
    kReplace,  ///< in the place of `element`
    kAround    ///< `element` becomes the last child of what is dropped
  };
  Kind kind = Kind::kInto;
  ElementIndex element{0};
  std::uint32_t position = 0;
};

/// Puts new elements there, given as XML. A single one without children that replaces a node takes
/// its children and what ports fit.
Outcome DropNew(Draft& draft, const NodeRules& rules, const DropSpot& spot,
                const std::vector<std::string>& fragments);

/// Moves the selection there.
Outcome DropMoved(Draft& draft, const NodeRules& rules, const DropSpot& spot);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_DROP_EDITS_H_
