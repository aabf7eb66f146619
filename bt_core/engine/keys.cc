#include "bt_core/engine/keys.h"

namespace coppice {
namespace {

std::string Quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

}  // namespace

std::string_view KeyOf(std::string_view text, std::string_view own_name) {
  if (text == "=") return own_name;
  const std::size_t first = text.find_first_not_of(' ');
  const std::size_t last = text.find_last_not_of(' ');
  if (first == std::string_view::npos || text[first] != '{' || text[last] != '}') return {};
  const std::string_view key = text.substr(first + 1, last - first - 1);
  if (key == "=") return own_name;
  return key == "@" ? std::string_view() : key;
}

ScopeIndex KeyTable::AddScope(ScopeIndex parent, bool autoremap) {
  scopes_.push_back({{}, parent, autoremap});
  return static_cast<ScopeIndex>(scopes_.size() - 1);
}

SlotIndex KeyTable::AddSlot(std::string key, ScopeIndex scope, const Type* type) {
  layout_.slots.push_back({std::move(key), scope, type, Value()});
  return static_cast<SlotIndex>(layout_.slots.size() - 1);
}

SlotIndex KeyTable::Resolve(std::string_view key, ScopeIndex scope) {
  if (key.front() == '@') {
    key.remove_prefix(1);
    scope = 0;
  }
  const auto found = scopes_[scope].keys.find(key);
  if (found != scopes_[scope].keys.end()) return found->second;
  const bool to_parent = scope != 0 && scopes_[scope].autoremap && key.front() != '_';
  const SlotIndex slot =
      to_parent ? Resolve(key, scopes_[scope].parent) : AddSlot(std::string(key), scope, nullptr);
  scopes_[scope].keys.emplace(key, slot);
  return slot;
}

void KeyTable::SetType(SlotIndex index, const Registry::Entry& entry, const PortDeclaration& port,
                       const Document& document, std::uint32_t offset) {
  SlotDefinition& slot = layout_.slots[index];
  if (!slot.type) {
    slot.type = port.type;
    first_use_[index] = {&entry, &port};
  } else if (slot.type != port.type) {
    const auto& [first_entry, first_port] = first_use_.at(index);
    diagnostics_.Error(document.Location(offset),
                       "key " + Quoted(slot.key) + " is " + slot.type->name + " (from " +
                           first_entry->manifest.id + "." + first_port->name + "), but port " +
                           Quoted(port.name) + " of " + entry.manifest.id + " is " +
                           port.type->name);
  }
}

void KeyTable::Remap(const Document& document, const Element& element, ScopeIndex outer,
                     ScopeIndex inner) {
  for (const Attribute* a = document.attributes_begin(element);
       a != document.attributes_end(element); ++a) {
    if (IsReservedAttribute(a->name)) continue;
    const std::string_view key = KeyOf(a->value, a->name);
    SlotIndex slot = kNoSlot;
    if (!key.empty()) {
      slot = Resolve(key, outer);
    } else {
      slot = AddSlot(std::string(a->name), inner, nullptr);
      literals_.push_back({slot, &document, a});
    }
    scopes_[inner].keys.emplace(a->name, slot);
  }
}

void KeyTable::ConvertLiterals() {
  for (SlotDefinition& slot : layout_.slots) {
    if (!slot.type) slot.type = &TypeOf<std::string>();
  }
  for (const Literal& literal : literals_) {
    SlotDefinition& slot = layout_.slots[literal.slot];
    const std::string_view text = literal.attribute->value;
    if (slot.initial.Parse(*slot.type, text)) continue;
    diagnostics_.Error(literal.document->Location(literal.attribute->value_offset),
                       Quoted(text) + " is not a value for key " + Quoted(slot.key) + " inside",
                       std::string("expected ") + slot.type->name);
  }
}

}  // namespace coppice
