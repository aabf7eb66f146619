// Which slot a name means at a place of a tree that is compiled already: for conditions and values
// that come from outside while the tree runs.
#ifndef COPPICE_BT_CORE_LIVE_DEBUG_SCOPE_KEYS_H_
#define COPPICE_BT_CORE_LIVE_DEBUG_SCOPE_KEYS_H_

#include <string>
#include <string_view>
#include <vector>

#include "bt_core/engine/program.h"

namespace coppice {

/// The slot of a key as nodes of that scope name it, with the remapping of SubTrees; "@key" is a
/// key of the main tree. kNoSlot: no port and no script of the tree uses it.
SlotIndex FindKey(const Program& program, ScopeIndex scope, std::string_view key);

/// The keys that belong to the scope itself or to a scope around it, for hints.
std::vector<std::string> KeysAround(const Program& program, ScopeIndex scope);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DEBUG_SCOPE_KEYS_H_
