// Joins texts.
#pragma once

#include <string>
#include <string_view>

namespace BT {

inline std::string StrCat() { return {}; }

/// "a" + "b" + ...: of all that converts to std::string_view.
template <class... Texts>
std::string StrCat(std::string_view first, const Texts&... others) {
  std::string joined(first);
  (joined.append(std::string_view(others)), ...);
  return joined;
}

template <class... Texts>
void StrAppend(std::string* destination, const Texts&... texts) {
  (destination->append(std::string_view(texts)), ...);
}

}  // namespace BT
