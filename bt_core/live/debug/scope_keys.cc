#include "bt_core/live/debug/scope_keys.h"

#include <optional>

#include "bt_core/model/keys.h"
#include "bt_core/model/manifest.h"

namespace coppice {
namespace {

bool IsAutoremapped(const Program& program, ScopeIndex scope) {
  return IsAutoremapped(program.TagOf(program.trees[scope].node));
}

// What the SubTree node, or else the model of its tree, gives for a name inside; nothing if it
// gives none. With _autoremap no default of the model counts.
std::optional<std::string> GivenText(const Program& program, ScopeIndex scope,
                                     std::string_view name) {
  const TreeInstance& instance = program.trees[scope];
  const StartTag tag = program.TagOf(instance.node);
  if (const std::string* given = tag.Find(name)) return *given;
  const auto model = program.subtree_models.find(instance.id);
  if (IsAutoremapped(tag) || model == program.subtree_models.end()) return std::nullopt;
  const PortModel* port = model->second.FindPort(name);
  return port ? port->default_text : std::nullopt;
}

ScopeIndex ScopeAround(const Program& program, ScopeIndex scope) {
  return program.info[program.trees[scope].node].scope;
}

}  // namespace

SlotIndex FindKey(const Program& program, ScopeIndex scope, std::string_view key) {
  if (key.empty()) return kNoSlot;
  if (key.front() == '@') return FindKey(program, kMainScope, key.substr(1));
  const SlotIndex slot = program.layout.Find(scope, key);
  if (slot != kNoSlot || scope == kMainScope) return slot;
  const std::optional<std::string> text = GivenText(program, scope, key);
  const std::string_view outside = text ? KeyOf(*text, key) : std::string_view();
  if (outside.empty() && (!IsAutoremapped(program, scope) || IsPrivateKey(key))) return kNoSlot;
  return FindKey(program, ScopeAround(program, scope), outside.empty() ? key : outside);
}

std::vector<std::string> KeysAround(const Program& program, ScopeIndex scope) {
  std::vector<std::string> keys;
  for (const SlotDefinition& slot : program.layout.slots) {
    if (!slot.key.empty() && FindKey(program, scope, slot.key) != kNoSlot) {
      keys.push_back(slot.key);
    }
  }
  if (scope == kMainScope) return keys;
  for (const auto& [name, value] : program.TagOf(program.trees[scope].node).attributes) {
    if (!IsReservedAttribute(name)) keys.push_back(name);  // a key inside
  }
  return keys;
}

}  // namespace coppice
