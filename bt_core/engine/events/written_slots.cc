#include "bt_core/engine/events/written_slots.h"

namespace coppice {
namespace {

void AddScript(const Program& program, std::uint32_t script, std::vector<SlotIndex>& slots) {
  if (script == kNoScript) return;
  const std::vector<SlotIndex>& writes = program.scripts[script].writes();
  slots.insert(slots.end(), writes.begin(), writes.end());
}

void AddPorts(const Program& program, NodeIndex node, std::vector<SlotIndex>& slots) {
  const Registry::Entry* entry = program.info[node].entry;
  if (!entry) return;
  const std::uint32_t first = program.FirstPort(node);
  for (std::uint32_t k = 0; k < entry->declarations.size(); ++k) {
    const PortDeclaration& port = entry->declarations[k];
    const SlotIndex slot = program.ports[first + k].slot;
    if (slot == kNoSlot) continue;
    if (port.type == &TypeOf<ScriptCode>()) {
      AddScript(program, slot, slots);
    } else if (port.direction == PortDirection::kOutput ||
               port.direction == PortDirection::kInOut) {
      slots.push_back(slot);
    }
  }
}

}  // namespace

WrittenSlots WrittenSlotsOf(const Program& program) {
  WrittenSlots written;
  auto guards = program.guards.begin();
  for (NodeIndex node = 0; node < program.nodes.size(); ++node) {
    written.first.push_back(static_cast<std::uint32_t>(written.slots.size()));
    AddPorts(program, node, written.slots);
    if (guards == program.guards.end() || guards->node != node) continue;
    for (const std::uint32_t script : guards->scripts) AddScript(program, script, written.slots);
    ++guards;
  }
  written.first.push_back(static_cast<std::uint32_t>(written.slots.size()));
  return written;
}

}  // namespace coppice
