#include "bt_core/live/client/part_packing.h"

#include <cstdint>

namespace coppice {
namespace {

constexpr std::size_t kLengthSize = 4;

void AppendLength(std::string& out, std::uint32_t length) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(length >> shift & 0xff);
}

std::size_t ReadLength(std::string_view bytes) {
  std::size_t length = 0;
  for (std::size_t i = kLengthSize; i-- > 0;) {
    length = length << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return length;
}

}  // namespace

std::string PackParts(const std::vector<std::string>& parts) {
  std::size_t size = 0;
  for (const std::string& part : parts) size += kLengthSize + part.size();
  std::string message;
  message.reserve(size);
  for (const std::string& part : parts) {
    AppendLength(message, static_cast<std::uint32_t>(part.size()));
    message += part;
  }
  return message;
}

std::vector<std::string> UnpackParts(std::string_view message) {
  std::vector<std::string> parts;
  while (!message.empty()) {
    if (message.size() < kLengthSize || parts.size() == kMaxPackedParts) return {};
    const std::size_t length = ReadLength(message);
    message.remove_prefix(kLengthSize);
    if (length > message.size()) return {};
    parts.emplace_back(message.substr(0, length));
    message.remove_prefix(length);
  }
  return parts;
}

}  // namespace coppice
