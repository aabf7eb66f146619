#include "tests/fuzz/frames.h"

#include <algorithm>

namespace coppice::fuzz {
namespace {

// The whole of a state is not packed: its cause, tick and time stand before.
std::size_t PlainBytes(FrameType type, std::size_t size) {
  constexpr std::size_t kHead = 3;
  if (type == FrameType::kState) return std::min(kHead, size);
  return type == FrameType::kTree || type == FrameType::kEvents ? 0 : size;
}

}  // namespace

bool TakeFrame(std::string_view& bytes, LooseFrame& frame) {
  constexpr std::size_t kHead = 3;
  if (bytes.size() < kHead) return false;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const std::size_t size = std::min<std::size_t>(byte(1) | byte(2) << 8, bytes.size() - kHead);
  frame = {byte(0), bytes.substr(kHead, size)};
  bytes.remove_prefix(kHead + size);
  return true;
}

void AppendFrame(unsigned char type, std::string_view payload, std::string& out) {
  out += static_cast<char>(type);
  out += static_cast<char>(payload.size() & 0xff);
  out += static_cast<char>(payload.size() >> 8);
  out += payload;
}

Bytes Seal(const LooseFrame& frame, Packer& packer) {
  const auto type = static_cast<FrameType>(frame.type);
  Bytes bytes;
  OpenFrame(bytes, type);
  const auto* const begin = reinterpret_cast<const std::uint8_t*>(frame.payload.data());
  const std::size_t plain = PlainBytes(type, frame.payload.size());
  bytes.insert(bytes.end(), begin, begin + plain);
  if (type == FrameType::kTree || type == FrameType::kState) packer.Restart();
  if (plain < frame.payload.size()) {
    packer.Pack(Bytes(begin + plain, begin + frame.payload.size()), bytes);
  }
  CloseFrame(bytes, 0);
  SealFrame(bytes.data());
  return bytes;
}

}  // namespace coppice::fuzz
