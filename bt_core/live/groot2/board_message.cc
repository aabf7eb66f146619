#include "bt_core/live/groot2/board_message.h"

#include <nlohmann/json.hpp>
#include <set>

#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

using Json = nlohmann::json;

Json ConvertOther(const std::string& text, const Type* type) {
  Json value = Json::parse(text, nullptr, false);
  if (value.is_discarded()) return text;
  if (value.is_object() && type) value["__type"] = type->name;
  return value;
}

Json Convert(const std::string& bytes, const Type* type) {
  const PlainValue value = ReadPlainValue(bytes);
  if (const std::string* text = std::get_if<std::string>(&value)) {
    return FormOfValue(bytes) == ValueForm::kJson ? ConvertOther(*text, type) : Json(*text);
  }
  if (const bool* flag = std::get_if<bool>(&value)) return *flag;
  if (const std::int64_t* number = std::get_if<std::int64_t>(&value)) return *number;
  if (const std::uint64_t* number = std::get_if<std::uint64_t>(&value)) return *number;
  if (const double* number = std::get_if<double>(&value)) return *number;
  return nullptr;
}

}  // namespace

std::string WriteBoards(const Layout& layout, const std::vector<ScopeIndex>& scopes,
                        const std::vector<std::string>& values) {
  Json boards;
  std::vector<Json*> board_of(layout.scopes.size());  // null: was not asked for
  for (const ScopeIndex scope : scopes) board_of[scope] = &boards[layout.scopes[scope]];
  for (SlotIndex slot{0}; slot < layout.slots.size(); ++slot) {
    const SlotDefinition& definition = layout.slots[slot];
    Json* const board = board_of[definition.scope];
    if (board && !definition.key.empty()) {
      (*board)[definition.key] = Convert(values[slot], definition.type);
    }
  }
  std::string bytes;
  Json::to_msgpack(boards, bytes);
  return bytes;
}

std::vector<ScopeIndex> FindScopes(const Layout& layout,
                                   const std::vector<std::string_view>& names) {
  const std::set<std::string_view> wanted(names.begin(), names.end());
  std::vector<ScopeIndex> scopes;
  for (ScopeIndex scope{0}; scope < layout.scopes.size(); ++scope) {
    if (wanted.count(layout.scopes[scope]) > 0) scopes.push_back(scope);
  }
  return scopes;
}

}  // namespace coppice
