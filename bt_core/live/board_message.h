// Blackboard values as MessagePack.
#ifndef COPPICE_BT_CORE_LIVE_BOARD_MESSAGE_H_
#define COPPICE_BT_CORE_LIVE_BOARD_MESSAGE_H_

#include <string>
#include <vector>

#include "bt_core/data/blackboard.h"

namespace coppice {

/// Map of scope name -> map of key -> value, with the keys that belong to the scope itself.
/// Numbers, bool and string are themselves, a key without value is nil, everything else is its
/// printed text. No scope: nil. The source of the form is the BLACKBOARD reply of the Groot2
/// protocol.
std::string WriteBoards(const Layout& layout, const std::vector<ScopeIndex>& scopes,
                        const std::vector<Value>& values);

/// The scopes of those names; names that there are not are left out.
std::vector<ScopeIndex> FindScopes(const Layout& layout,
                                   const std::vector<std::string_view>& names);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_BOARD_MESSAGE_H_
