#include "bt_core/frames/frame.h"

#include "bt_core/frames/crc32c.h"

namespace coppice {
namespace {

constexpr std::size_t kCrcOffset = 5;

void Store(std::uint8_t* at, std::uint32_t number) {
  for (int i = 0; i < 4; ++i) at[i] = static_cast<std::uint8_t>(number >> 8 * i);
}

std::uint32_t Checksum(const std::uint8_t* frame, std::size_t payload_size) {
  const std::uint32_t before = Crc32c(frame, kCrcOffset);
  return Crc32c(frame + kFrameHeaderSize, payload_size, before);
}

}  // namespace

void AppendPreamble(Bytes& out) {
  out.insert(out.end(), std::begin(kRecordMagic), std::end(kRecordMagic));
  Encoder(out).Fixed32(kRecordVersion);
}

std::size_t OpenFrame(Bytes& out, FrameType type) {
  const std::size_t frame = out.size();
  Encoder encoder(out);
  encoder.Fixed32(0);
  encoder.Byte(static_cast<std::uint8_t>(type));
  encoder.Fixed32(0);
  return frame;
}

void CloseFrame(Bytes& out, std::size_t frame) {
  Store(out.data() + frame, static_cast<std::uint32_t>(out.size() - frame - kFrameHeaderSize));
}

std::size_t SealFrame(std::uint8_t* frame) {
  const std::size_t payload_size = ReadFrameHeader(frame).payload_size;
  Store(frame + kCrcOffset, Checksum(frame, payload_size));
  return kFrameHeaderSize + payload_size;
}

FrameHeader ReadFrameHeader(const std::uint8_t* bytes) {
  Decoder decoder(bytes, bytes + kFrameHeaderSize);
  const std::uint32_t payload_size = decoder.Fixed32();
  const std::uint8_t type = decoder.Byte();
  return {payload_size, type, decoder.Fixed32()};
}

bool IsPlausible(const FrameHeader& header) {
  return header.type >= static_cast<std::uint8_t>(FrameType::kTree) &&
         header.type <= static_cast<std::uint8_t>(FrameType::kEnd) &&
         header.payload_size <= kMaxPayloadSize;
}

bool IsWhole(const std::uint8_t* frame, const FrameHeader& header) {
  return header.crc == Checksum(frame, header.payload_size);
}

}  // namespace coppice
