#include "bt_core/engine/compile/keys.h"

#include <utility>

#include "bt_core/model/keys.h"

namespace coppice {

ScopeIndex KeyTable::AddScope(ScopeIndex parent, bool autoremap) {
  scopes_.push_back({{}, parent, autoremap});
  return static_cast<ScopeIndex>(scopes_.size() - 1);
}

SlotIndex KeyTable::AddSlot(std::string key, ScopeIndex scope, const Type* type, Value initial) {
  constexpr std::size_t kOfKey = 400;  // as measured
  bytes_ += sizeof(layout_.slots[0]) + (key.empty() ? 0 : kOfKey + 2 * key.size());
  layout_.slots.push_back({std::move(key), scope, type, std::move(initial)});
  return static_cast<SlotIndex>(layout_.slots.size() - 1);
}

ScopeIndex KeyTable::Home(std::string_view key, ScopeIndex scope) const {
  while (scope != 0 && scopes_[scope].autoremap && !IsPrivateKey(key) &&
         scopes_[scope].keys.count(key) == 0) {
    scope = scopes_[scope].parent;
  }
  return scope;
}

SlotIndex KeyTable::Resolve(std::string_view key, ScopeIndex scope) {
  if (key.front() == '@') {
    if (!keeps_outer_keys_) key.remove_prefix(1);
    scope = kMainScope;
  }
  const auto found = scopes_[scope].keys.find(key);
  if (found != scopes_[scope].keys.end()) return found->second;
  const ScopeIndex home = Home(key, scope);
  const auto at_home = scopes_[home].keys.find(key);
  const SlotIndex slot = at_home != scopes_[home].keys.end()
                             ? at_home->second
                             : AddSlot(std::string(key), home, nullptr);
  for (ScopeIndex at = scope; at != home; at = scopes_[at].parent) Enter(key, at, slot);
  Enter(key, home, slot);
  return slot;
}

SlotIndex KeyTable::ResolveCopy(std::string_view key, ScopeIndex scope) {
  const auto found = scopes_[scope].keys.find(key);
  if (found != scopes_[scope].keys.end()) return found->second;
  return Resolve(names_.emplace_back(key), scope);
}

bool KeyTable::Has(std::string_view key, ScopeIndex scope) const {
  return scopes_[Home(key, scope)].keys.count(key) != 0;
}

void KeyTable::Bind(std::string_view key, ScopeIndex scope, SlotIndex slot) {
  Enter(key, scope, slot);
}

void KeyTable::Enter(std::string_view key, ScopeIndex scope, SlotIndex slot) {
  constexpr std::size_t kOfName = 100;
  if (scopes_[scope].keys.emplace(key, slot).second) bytes_ += kOfName;
}

}  // namespace coppice
