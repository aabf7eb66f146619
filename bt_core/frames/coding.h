// How numbers and texts become bytes in a history, and back. docs/record_format.md is the
// reference.
#ifndef COPPICE_BT_CORE_FRAMES_CODING_H_
#define COPPICE_BT_CORE_FRAMES_CODING_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/clock.h"

namespace coppice {

using Bytes = std::vector<std::uint8_t>;

/// Appends to a buffer. Allocates only when the buffer must grow.
class Encoder {
 public:
  explicit Encoder(Bytes& out) : out_(out) {}

  void Byte(std::uint8_t byte) { out_.push_back(byte); }
  /// Four bytes, little endian.
  void Fixed32(std::uint32_t number);
  /// Seven bits per byte, the lowest first; all but the last byte have bit 7 set.
  void Unsigned(std::uint64_t number) {
    while (number >= 0x80) {
      Byte(static_cast<std::uint8_t>(number | 0x80));
      number >>= 7;
    }
    Byte(static_cast<std::uint8_t>(number));
  }
  /// 0, -1, 1, -2, ... as Unsigned 0, 1, 2, 3, ...
  void Signed(std::int64_t number);
  /// Eight bytes, IEEE 754, little endian.
  void Double(double number);
  /// Length as Unsigned, then the bytes.
  void Text(std::string_view text);
  void At(Time time) { Signed(ToNanoseconds(time)); }

 private:
  Bytes& out_;
};

/// Reads what an Encoder wrote. Never reads past the end: then ok() becomes false and everything is
/// 0 or empty from there on.
class Decoder {
 public:
  Decoder(const std::uint8_t* begin, const std::uint8_t* end) : at_(begin), end_(end) {}

  std::uint8_t Byte();
  std::uint32_t Fixed32();
  std::uint64_t Unsigned();
  std::int64_t Signed();
  double Double();
  std::string Text();
  /// A text that lies where it is.
  std::string_view View();
  /// What a text consists of, to be decoded by itself.
  Decoder Part();
  /// All that is left.
  const std::uint8_t* at() const { return at_; }
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  Time At() { return TimeFromNanoseconds(Signed()); }

  /// A count of things of which each takes at least one byte; one that cannot be is an error.
  std::size_t Count();
  /// An index below the limit; any other is an error.
  std::uint32_t Index(std::size_t limit);

  /// What was read makes no sense: as if it were cut off.
  void Fail();
  bool ok() const { return ok_; }
  bool at_end() const { return at_ == end_; }

 private:
  bool Need(std::uint64_t bytes);

  const std::uint8_t* at_;
  const std::uint8_t* end_;
  bool ok_ = true;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_CODING_H_
