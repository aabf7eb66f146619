#include "bt_core/live/debug/scope_keys.h"

#include <optional>

#include "bt_core/model/keys.h"
#include "bt_core/model/manifest.h"

namespace coppice {
namespace {

bool IsAutoremapped(const Program& program, ScopeIndex scope) {
  const NodeIndex node = program.trees[scope].node;
  return IsAutoremapped(program.DocumentOf(node), program.ElementOf(node));
}

// What the SubTree node, or else the model of its tree, gives for a name inside; nothing if it
// gives none. With _autoremap no default of the model counts.
std::optional<std::string_view> GivenText(const Program& program, ScopeIndex scope,
                                          std::string_view name) {
  const TreeInstance& instance = program.trees[scope];
  const Document& document = program.DocumentOf(instance.node);
  const Attribute* given = document.FindAttribute(program.ElementOf(instance.node), name);
  if (given) return given->value;
  if (IsAutoremapped(program, scope)) return std::nullopt;
  const NodeModel* model = program.project->SubTreeModel(instance.id);
  const PortModel* port = model ? model->FindPort(name) : nullptr;
  if (port && port->default_text) return *port->default_text;
  return std::nullopt;
}

ScopeIndex ScopeAround(const Program& program, ScopeIndex scope) {
  return program.info[program.trees[scope].node].scope;
}

}  // namespace

SlotIndex FindKey(const Program& program, ScopeIndex scope, std::string_view key) {
  if (key.empty()) return kNoSlot;
  if (key.front() == '@') return FindKey(program, 0, key.substr(1));
  for (;;) {
    const SlotIndex slot = program.layout.Find(scope, key);
    if (slot != kNoSlot || scope == 0) return slot;
    const std::optional<std::string_view> text = GivenText(program, scope, key);
    const std::string_view outside = text ? KeyOf(*text, key) : std::string_view();
    if (outside.empty() && (!IsAutoremapped(program, scope) || IsPrivateKey(key))) {
      return kNoSlot;
    }
    scope = ScopeAround(program, scope);
    if (!outside.empty()) key = outside;
    if (key.front() == '@') return FindKey(program, 0, key.substr(1));
  }
}

std::vector<std::string> KeysAround(const Program& program, ScopeIndex scope) {
  std::vector<std::string> keys;
  for (const SlotDefinition& slot : program.layout.slots) {
    if (!slot.key.empty() && FindKey(program, scope, slot.key) != kNoSlot) {
      keys.push_back(slot.key);
    }
  }
  if (scope == 0) return keys;
  const NodeIndex node = program.trees[scope].node;  // its attributes are keys inside
  const Document& document = program.DocumentOf(node);
  const Element& element = program.ElementOf(node);
  for (const Attribute* a = document.attributes_begin(element);
       a != document.attributes_end(element); ++a) {
    if (!IsReservedAttribute(a->name)) keys.emplace_back(a->name);
  }
  return keys;
}

}  // namespace coppice
