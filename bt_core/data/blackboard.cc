#include "bt_core/data/blackboard.h"

namespace coppice {

SlotIndex Layout::Find(ScopeIndex scope, std::string_view key) const {
  for (SlotIndex i{0}; i < slots.size(); ++i) {
    if (slots[i].scope == scope && !slots[i].key.empty() && slots[i].key == key) return i;
  }
  return kNoSlot;
}

Blackboard MakeBlackboard(const Layout& layout) {
  Blackboard blackboard(layout.slots.size());
  for (SlotIndex i{0}; i < blackboard.size(); ++i) {
    blackboard[i].value = layout.slots[i].initial;
  }
  return blackboard;
}

}  // namespace coppice
