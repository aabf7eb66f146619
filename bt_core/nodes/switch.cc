#include "bt_core/nodes/switch.h"

#include <cmath>
#include <limits>
#include <optional>

namespace coppice {
namespace {

std::optional<double> NumberIn(std::string_view text) {
  double number = 0;
  if (!ValueTraits<double>::Parse(text, number)) return std::nullopt;
  return number;
}

std::optional<double> NumberOf(const Value& value) {
  if (value.Is<double>()) return value.Get<double>();
  if (value.Is<int>()) return value.Get<int>();
  if (value.Is<unsigned>()) return value.Get<unsigned>();
  if (value.Is<std::int64_t>()) return static_cast<double>(value.Get<std::int64_t>());
  if (value.Is<std::uint64_t>()) return static_cast<double>(value.Get<std::uint64_t>());
  if (value.Is<bool>()) return value.Get<bool>() ? 1 : 0;
  if (value.Is<std::string>()) return NumberIn(value.Get<std::string>());
  return std::nullopt;
}

}  // namespace

bool MatchesText(const Value& value, std::string_view text) {
  if (value.Is<std::string>() && value.Get<std::string>() == text) return true;
  constexpr double kEpsilon = std::numeric_limits<float>::epsilon();
  const std::optional<double> number = NumberOf(value);
  const std::optional<double> other = number ? NumberIn(text) : std::nullopt;
  if (other) return std::abs(*number - *other) <= kEpsilon;
  return !value.Is<std::string>() && value.Print() == text;
}

}  // namespace coppice
