// Names of the values of an enum, read from what the compiler calls them: for numbers from -128 to
// 127, of enums whose values have a name. What users of behaviour trees need of the library of that
// name, and no more.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace magic_enum {
namespace details {

constexpr int kLowest = -128;
constexpr std::size_t kCount = 256;

// Empty for a number without name.
template <class E, E value>
constexpr std::string_view NameOf() {
  std::string_view text = __PRETTY_FUNCTION__;  // "... [with E = Color; E value = RED; ...]"
  text = text.substr(0, text.find_first_of(";]", text.find("value = ")));
  text = text.substr(text.find("value = ") + 8);
  if (text.empty() || text.front() == '(' || text.front() == '-') return {};
  if (text.front() >= '0' && text.front() <= '9') return {};
  const std::size_t scope = text.rfind("::");
  return scope == std::string_view::npos ? text : text.substr(scope + 2);
}

template <class E, int number>
constexpr std::string_view NameOfNumber() {
  using Underlying = std::underlying_type_t<E>;
  if constexpr (std::is_unsigned_v<Underlying> && number < 0) {
    return {};
  } else {
    return NameOf<E, static_cast<E>(number)>();
  }
}

template <class E, std::size_t... k>
constexpr auto AllNames(std::index_sequence<k...>) {
  return std::array<std::string_view, kCount>{NameOfNumber<E, kLowest + static_cast<int>(k)>()...};
}

template <class E>
inline constexpr auto kNames = AllNames<E>(std::make_index_sequence<kCount>());

template <class E>
constexpr std::size_t Count() {
  std::size_t count = 0;
  for (const std::string_view name : kNames<E>) count += !name.empty();
  return count;
}

}  // namespace details

template <class E>
constexpr std::size_t enum_count() {
  return details::Count<E>();
}

/// Pairs of value and name, by ascending number.
template <class E>
constexpr auto enum_entries() {
  std::array<std::pair<E, std::string_view>, details::Count<E>()> entries{};
  std::size_t next = 0;
  for (std::size_t k = 0; k < details::kCount; ++k) {
    if (details::kNames<E>[k].empty()) continue;
    entries[next].first = static_cast<E>(details::kLowest + static_cast<int>(k));
    entries[next++].second = details::kNames<E>[k];
  }
  return entries;
}

template <class E>
constexpr auto enum_values() {
  std::array<E, details::Count<E>()> values{};
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = enum_entries<E>()[k].first;
  return values;
}

/// Empty for a number without name.
template <class E>
constexpr std::string_view enum_name(E value) {
  for (const auto& [known, name] : enum_entries<E>()) {
    if (known == value) return name;
  }
  return {};
}

template <class E>
constexpr std::optional<E> enum_cast(std::string_view name) {
  for (const auto& [value, known] : enum_entries<E>()) {
    if (known == name) return value;
  }
  return std::nullopt;
}

}  // namespace magic_enum
