#include "bt_core/frames/crc32c.h"

#include <array>

namespace coppice {
namespace {

constexpr std::uint32_t kPolynomial = 0x82f63b78;  // bits in reverse order

constexpr std::array<std::uint32_t, 256> MakeTable() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? kPolynomial : 0);
    table[byte] = crc;
  }
  return table;
}

constexpr std::array<std::uint32_t, 256> kTable = MakeTable();

}  // namespace

std::uint32_t Crc32c(const void* bytes, std::size_t size, std::uint32_t before) {
  const auto* at = static_cast<const std::uint8_t*>(bytes);
  std::uint32_t crc = ~before;
  for (std::size_t i = 0; i < size; ++i) crc = kTable[(crc ^ at[i]) & 0xff] ^ crc >> 8;
  return ~crc;
}

}  // namespace coppice
