// Which slots each node may write, so that after its tick only those need a look.
#ifndef COPPICE_BT_CORE_ENGINE_EVENTS_WRITTEN_SLOTS_H_
#define COPPICE_BT_CORE_ENGINE_EVENTS_WRITTEN_SLOTS_H_

#include <cstdint>
#include <vector>

#include "bt_core/engine/program.h"

namespace coppice {

/// The slots of node i are slots[first[i]] .. slots[first[i + 1]]: those of its output and inout
/// ports, and those that its scripts, guards and hooks assign.
struct WrittenSlots {
  std::vector<std::uint32_t> first;
  std::vector<SlotIndex> slots;
};

WrittenSlots WrittenSlotsOf(const Program& program);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EVENTS_WRITTEN_SLOTS_H_
