// Ticks as few bytes, each told from the one before it, and back. A status that a node near the one
// before it returned is one byte. docs/record_format.md is the reference.
#ifndef COPPICE_BT_CORE_FRAMES_TICK_CODING_H_
#define COPPICE_BT_CORE_FRAMES_TICK_CODING_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/engine/events.h"
#include "bt_core/frames/coding.h"

namespace coppice {

/// A value or text with more bytes than this is cut.
inline constexpr std::size_t kMaxValueBytes = 64 << 10;
/// The same in a frame that holds much already: a reader does not take frames of any length.
inline constexpr std::size_t kShortValueBytes = 64;

/// The bytes of a value (data/value_bytes.h), or, if they are more than `limit`, those of a text
/// that begins as the value does and ends in "... (cut: N bytes)".
std::string CutValue(std::string_view bytes, std::size_t limit = kMaxValueBytes);
/// The same for a text without form.
std::string CutText(std::string_view text, std::size_t limit = kMaxValueBytes);

/// Number and time of a tick, which the next one is told from.
struct TickPlace {
  std::uint64_t tick = 0;
  Time time{};
  Duration step{0};  ///< from the tick before it
};

class TickEncoder {
 public:
  /// What comes next is told from here.
  void Restart(std::uint64_t tick, Time time);
  void Encode(const TickEvents& events, Bytes& out);

  /// How many ticks in a row, up to the last one, had exactly the events of the tick before them.
  /// Most ticks of most trees do, and cost next to nothing then.
  std::uint64_t repetitions() const { return repetitions_; }

 private:
  bool Repeats(EventWords words, std::size_t before) const;
  void EncodeEvents(EventWords words, std::size_t before);

  TickPlace place_;
  std::vector<std::uint32_t> words_;  // of the last tick
  Bytes events_;                      // begins with what they became,
  std::size_t encoded_ = 0;           // so many bytes
  bool is_reusable_ = false;          // none of its values was cut shorter than usual
  std::uint64_t repetitions_ = 0;
};

/// How many nodes and slots there are.
struct TreeSize {
  std::size_t nodes = 0;
  std::size_t slots = 0;
};

class TickDecoder {
 public:
  void Restart(std::uint64_t tick, Time time) { place_ = {tick, time, Duration(0)}; }
  /// The next tick; its words are valid until the next call. Nothing if the bytes are no tick of
  /// such a tree.
  std::optional<TickEvents> Decode(Decoder& in, const TreeSize& size);

 private:
  static constexpr std::uint64_t kMaxMicroseconds = INT64_MAX / 1000;

  TickPlace place_;
  EventWriter words_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_TICK_CODING_H_
