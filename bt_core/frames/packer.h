// zstd streams (RFC 8878) that are flushed piece by piece: each piece can be unpacked as soon as it
// and all before it are there.
#ifndef COPPICE_BT_CORE_FRAMES_PACKER_H_
#define COPPICE_BT_CORE_FRAMES_PACKER_H_

#include <cstddef>
#include <cstdint>
#include <memory>

#include "bt_core/frames/coding.h"

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace coppice {

class Packer {
 public:
  /// Throws std::bad_alloc.
  Packer();
  ~Packer();
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;

  /// The next piece begins a new stream.
  void Restart();
  /// Appends the next piece of the stream.
  void Pack(const Bytes& raw, Bytes& out);

 private:
  ZSTD_CCtx_s* context_;
};

class Unpacker {
 public:
  /// Throws std::bad_alloc.
  Unpacker();
  ~Unpacker();
  Unpacker(Unpacker&& other) noexcept;
  Unpacker& operator=(Unpacker&& other) noexcept;

  /// The next piece begins a new stream.
  void Restart();
  /// Appends what a piece holds. False if it is damaged or would hold more than `limit` bytes.
  bool Unpack(const std::uint8_t* data, std::size_t size, std::size_t limit, Bytes& out);

 private:
  ZSTD_DCtx_s* context_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_PACKER_H_
