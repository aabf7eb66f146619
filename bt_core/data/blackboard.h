// The blackboard: one flat array of typed slots. Names are resolved to slot numbers when a tree is
// loaded; ticking never looks up a name.
//
// A Layout is the immutable description (which scopes and keys there are, their types and first
// values); a Blackboard holds the values of one running tree. Each SubTree instance is a scope; a
// remapped key is the same slot under two names.
#ifndef COPPICE_BT_CORE_DATA_BLACKBOARD_H_
#define COPPICE_BT_CORE_DATA_BLACKBOARD_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/data/inbox.h"
#include "bt_core/data/value.h"

namespace coppice {

using ScopeIndex = std::uint32_t;

struct Slot {
  Value value;               ///< empty until it is written for the first time
  std::uint32_t writes = 0;  ///< counts every write
  std::uint32_t epoch = 0;   ///< mailboxes: of the message that lies here
};

struct SlotDefinition {
  std::string key;             ///< empty for literals and mailboxes
  ScopeIndex scope = 0;        ///< where the key was first named
  const Type* type = nullptr;  ///< of all ports that share this slot
  Value initial;               ///< a literal, or empty
};

struct Layout {
  std::vector<std::string> scopes;  ///< instance path of each scope; the root's is its tree ID
  std::vector<SlotDefinition> slots;

  /// The slot that a key names in a scope where it was first used, or kNoSlot. For wiring and
  /// inspection.
  SlotIndex Find(ScopeIndex scope, std::string_view key) const;
};

using Blackboard = std::vector<Slot>;

/// All slots with their first values.
Blackboard MakeBlackboard(const Layout& layout);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_DATA_BLACKBOARD_H_
