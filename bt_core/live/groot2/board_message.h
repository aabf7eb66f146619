// Blackboard values as MessagePack.
#ifndef COPPICE_BT_CORE_LIVE_GROOT2_BOARD_MESSAGE_H_
#define COPPICE_BT_CORE_LIVE_GROOT2_BOARD_MESSAGE_H_

#include <string>
#include <vector>

#include "bt_core/data/blackboard.h"

namespace coppice {

/// Map of scope name -> map of key -> value, with the keys that belong to the scope itself.
/// `values` are those of all slots, as in data/value_bytes.h. Numbers, bool and string are
/// themselves, a key without value is nil, a value of another type is its JSON, with "__type" if
/// that is an object. A scope without keys, and no scope at all: nil. The source of the form is the
/// BLACKBOARD reply of the Groot2 protocol.
std::string WriteBoards(const Layout& layout, const std::vector<ScopeIndex>& scopes,
                        const std::vector<std::string>& values);

/// The scopes of those names; names that there are not are left out.
std::vector<ScopeIndex> FindScopes(const Layout& layout,
                                   const std::vector<std::string_view>& names);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_GROOT2_BOARD_MESSAGE_H_
