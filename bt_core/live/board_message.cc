#include "bt_core/live/board_message.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace coppice {
namespace {

nlohmann::json Convert(const Value& value) {
  if (!value.has_value()) return nullptr;
  if (value.Is<bool>()) return value.Get<bool>();
  if (value.Is<int>()) return value.Get<int>();
  if (value.Is<unsigned>()) return value.Get<unsigned>();
  if (value.Is<std::int64_t>()) return value.Get<std::int64_t>();
  if (value.Is<std::uint64_t>()) return value.Get<std::uint64_t>();
  if (value.Is<double>()) return value.Get<double>();
  return value.Print();
}

}  // namespace

std::string WriteBoards(const Layout& layout, const std::vector<ScopeIndex>& scopes,
                        const std::vector<Value>& values) {
  nlohmann::json boards;
  for (const ScopeIndex scope : scopes) {
    nlohmann::json& board = boards[layout.scopes[scope]];
    for (SlotIndex slot = 0; slot < layout.slots.size(); ++slot) {
      const SlotDefinition& definition = layout.slots[slot];
      if (definition.scope != scope || definition.key.empty()) continue;
      board[definition.key] = Convert(values[slot]);
    }
  }
  std::string bytes;
  nlohmann::json::to_msgpack(boards, bytes);
  return bytes;
}

std::vector<ScopeIndex> FindScopes(const Layout& layout,
                                   const std::vector<std::string_view>& names) {
  std::vector<ScopeIndex> scopes;
  for (ScopeIndex scope = 0; scope < layout.scopes.size(); ++scope) {
    if (std::find(names.begin(), names.end(), layout.scopes[scope]) != names.end()) {
      scopes.push_back(scope);
    }
  }
  return scopes;
}

}  // namespace coppice
