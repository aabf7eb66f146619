#include "bt_core/data/port.h"

namespace coppice {
namespace {

thread_local PortCollector* current_collector = nullptr;

}  // namespace

const char* ToString(PortDirection direction) {
  switch (direction) {
    case PortDirection::kInput:
      return "input";
    case PortDirection::kOutput:
      return "output";
    case PortDirection::kInOut:
      return "inout";
    case PortDirection::kMailbox:
      return "mailbox";
  }
  return "?";
}

PortBase::PortBase(PortDeclaration declaration) {
  if (current_collector) current_collector->ports.push_back({std::move(declaration), this});
}

void PortBase::Bind(Slot* slot, const Time& now, SlotIndex index,
                    const std::shared_ptr<Inbox>& inbox) {
  slot_ = slot;
  now_ = &now;
  OnBound(index, inbox);
}

PortCollector::PortCollector() : outer_(current_collector) { current_collector = this; }
PortCollector::~PortCollector() { current_collector = outer_; }

}  // namespace coppice
