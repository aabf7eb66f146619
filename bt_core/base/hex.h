// Bytes as text, two hexadecimal digits for each, and back.
#ifndef COPPICE_BT_CORE_BASE_HEX_H_
#define COPPICE_BT_CORE_BASE_HEX_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace coppice {

inline constexpr std::string_view kHexDigits = "0123456789abcdef";

/// Of a string, a vector or an array of bytes. Not for secrets: it takes longer for some.
template <class Bytes>
std::string ToHex(const Bytes& bytes) {
  std::string digits;
  digits.reserve(2 * bytes.size());
  for (const auto one : bytes) {
    const auto byte = static_cast<std::uint8_t>(one);
    digits += kHexDigits[byte >> 4];
    digits += kHexDigits[byte & 15];
  }
  return digits;
}

/// Empty if they are none: small letters only, two digits for each byte.
inline std::vector<std::uint8_t> FromHex(std::string_view digits) {
  if (digits.size() % 2 != 0) return {};
  std::vector<std::uint8_t> bytes(digits.size() / 2);
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::size_t value = kHexDigits.find(digits[i]);
    if (value == std::string_view::npos) return {};
    bytes[i / 2] = static_cast<std::uint8_t>(bytes[i / 2] << 4 | value);
  }
  return bytes;
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_HEX_H_
