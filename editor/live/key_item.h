// How a key of the blackboard is named in the registry of items, and as the key that is chosen.
#ifndef COPPICE_EDITOR_LIVE_KEY_ITEM_H_
#define COPPICE_EDITOR_LIVE_KEY_ITEM_H_

#include <optional>
#include <string>

#include "bt_core/frames/tree_description.h"

namespace coppice::editor {

/// "blackboard/SCOPE/KEY".
inline std::string ItemOfKey(const DescribedSlot& slot) {
  return "blackboard/" + slot.scope + "/" + slot.name;
}

/// The key of that item; nothing if the tree has none.
inline std::optional<SlotIndex> KeyOfItem(const TreeDescription& tree, const std::string& item) {
  for (SlotIndex i{0}; i < tree.slots.size(); ++i) {
    if (ItemOfKey(tree.slots[i]) == item) return i;
  }
  return std::nullopt;
}

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_KEY_ITEM_H_
