// Frames: the checksummed pieces that a history consists of, on disk and on the wire. A record is
// the magic bytes, the version, and then nothing but frames.
#ifndef COPPICE_BT_CORE_FRAMES_FRAME_H_
#define COPPICE_BT_CORE_FRAMES_FRAME_H_

#include <cstddef>
#include <cstdint>

#include "bt_core/frames/coding.h"

namespace coppice {

inline constexpr std::uint8_t kRecordMagic[8] = {0x89, 'C', 'o', 'p', 'p', 'i', 'c', '\n'};
inline constexpr std::uint32_t kRecordVersion = 2;
inline constexpr std::size_t kPreambleSize = sizeof(kRecordMagic) + 4;

enum class FrameType : std::uint8_t {
  kTree = 1,    ///< what the tree is
  kState = 2,   ///< how it stands; reading can begin here, if the tree is known
  kEvents = 3,  ///< ticks; understood only if the frames since the last state are
  kGap = 4,     ///< what is missing
  kNote = 5,
  kEnd = 6,
};

/// On disk: payload size (4 bytes), type (1), CRC-32C of all but itself (4), payload.
struct FrameHeader {
  std::uint32_t payload_size;
  std::uint8_t type;
  std::uint32_t crc;
};
inline constexpr std::size_t kFrameHeaderSize = 9;
inline constexpr std::size_t kMaxPayloadSize = 64 << 20;
/// What a payload unpacks to has at most so many bytes.
inline constexpr std::size_t kMaxRawSize = 64 << 20;
/// Of one frame of events; those that are written have a tenth of that. Some kilobytes of zeros
/// could else unpack to gigabytes of ticks.
inline constexpr std::size_t kMaxTicksInFrame = 256 << 10;

/// Appends magic bytes and version.
void AppendPreamble(Bytes& out);

/// Opens a frame at the end of `out`; what is appended afterwards is its payload. Returns where it
/// begins, for CloseFrame.
std::size_t OpenFrame(Bytes& out, FrameType type);

/// Writes the size of the payload, which ends at the end of `out`. The checksum is still 0.
void CloseFrame(Bytes& out, std::size_t frame);

/// Computes and writes the checksum of a closed frame; returns the size of the whole frame.
std::size_t SealFrame(std::uint8_t* frame);

/// `bytes` are at least kFrameHeaderSize.
FrameHeader ReadFrameHeader(const std::uint8_t* bytes);

/// Whether type and size are possible.
bool IsPlausible(const FrameHeader& header);

/// Whether the checksum is right. `frame` is as long as its header says.
bool IsWhole(const std::uint8_t* frame, const FrameHeader& header);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_FRAME_H_
