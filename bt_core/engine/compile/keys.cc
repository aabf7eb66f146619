#include "bt_core/engine/compile/keys.h"

#include <utility>

namespace coppice {

namespace {

std::string_view Trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

std::string_view KeyOf(std::string_view text, std::string_view own_name) {
  text = Trim(text);
  if (text == "=") return own_name;
  if (text.size() < 2 || text.front() != '{' || text.back() != '}') return {};
  const std::string_view key = Trim(text.substr(1, text.size() - 2));
  if (key == "=") return own_name;
  if (key == "@" || key.find_first_of("{}") != std::string_view::npos) return {};
  return key;
}

ScopeIndex KeyTable::AddScope(ScopeIndex parent, bool autoremap) {
  scopes_.push_back({{}, parent, autoremap});
  return static_cast<ScopeIndex>(scopes_.size() - 1);
}

SlotIndex KeyTable::AddSlot(std::string key, ScopeIndex scope, const Type* type, Value initial) {
  layout_.slots.push_back({std::move(key), scope, type, std::move(initial)});
  return static_cast<SlotIndex>(layout_.slots.size() - 1);
}

ScopeIndex KeyTable::Home(std::string_view key, ScopeIndex scope) const {
  while (scope != 0 && scopes_[scope].autoremap && key.front() != '_' &&
         scopes_[scope].keys.count(key) == 0) {
    scope = scopes_[scope].parent;
  }
  return scope;
}

SlotIndex KeyTable::Resolve(std::string_view key, ScopeIndex scope) {
  if (key.front() == '@') {
    key.remove_prefix(1);
    scope = 0;
  }
  const auto found = scopes_[scope].keys.find(key);
  if (found != scopes_[scope].keys.end()) return found->second;
  const ScopeIndex home = Home(key, scope);
  const auto at_home = scopes_[home].keys.find(key);
  const SlotIndex slot = at_home != scopes_[home].keys.end()
                             ? at_home->second
                             : AddSlot(std::string(key), home, nullptr);
  for (ScopeIndex at = scope; at != home; at = scopes_[at].parent) scopes_[at].keys[key] = slot;
  scopes_[home].keys.emplace(key, slot);
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
  scopes_[scope].keys.emplace(key, slot);
}

}  // namespace coppice
