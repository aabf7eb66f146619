#include "bt_core/nodes/switch.h"

#include <cmath>
#include <limits>
#include <optional>

namespace coppice {
namespace {

std::optional<double> NumberIn(std::string_view text, const ScriptConstants& constants) {
  double number = 0;
  if (ValueTraits<double>::Parse(text, number)) return number;
  const auto constant = constants.find(text);
  if (constant == constants.end()) return std::nullopt;
  return static_cast<double>(constant->second);
}

std::optional<double> NumberOf(const Value& value, const ScriptConstants& constants) {
  switch (value.type()->kind) {
    case TypeKind::kBool:
      return value.Get<bool>() ? 1 : 0;
    case TypeKind::kInt:
      return value.Get<int>();
    case TypeKind::kUnsigned:
      return value.Get<unsigned>();
    case TypeKind::kInt64:
      return static_cast<double>(value.Get<std::int64_t>());
    case TypeKind::kUint64:
      return static_cast<double>(value.Get<std::uint64_t>());
    case TypeKind::kFloat:
      return value.Get<float>();
    case TypeKind::kDouble:
      return value.Get<double>();
    case TypeKind::kString:
      return NumberIn(value.Get<std::string>(), constants);
    case TypeKind::kEnum:
      return static_cast<double>(value.EnumeratorValue());
    case TypeKind::kOther:
      break;
  }
  return std::nullopt;
}

}  // namespace

bool MatchesText(const Value& value, std::string_view text, const ScriptConstants& constants) {
  const TypeKind kind = value.type()->kind;
  if (kind == TypeKind::kString && value.Get<std::string>() == text) return true;
  constexpr double kEpsilon = std::numeric_limits<float>::epsilon();
  const std::optional<double> number = NumberOf(value, constants);
  const std::optional<double> other = number ? NumberIn(text, constants) : std::nullopt;
  if (other) return std::abs(*number - *other) <= kEpsilon;
  return kind != TypeKind::kString && value.Print() == text;
}

}  // namespace coppice
