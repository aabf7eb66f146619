// EventReader for those who read every event of every tick: a status, which nearly all words are,
// is read without a call.
#ifndef COPPICE_BT_CORE_ENGINE_EVENTS_INLINE_EVENT_READER_H_
#define COPPICE_BT_CORE_ENGINE_EVENTS_INLINE_EVENT_READER_H_

#include <cstddef>
#include <cstdint>

#include "bt_core/engine/events/event_words.h"

namespace coppice {

class InlineEventReader {
 public:
  explicit InlineEventReader(EventWords words) : at_(words.data), end_(words.data + words.size) {}

  /// False at the end, and at words that are cut off. Of a status only code and index are set.
  bool Next(Event& event) {
    if (at_ == end_) return false;
    event.code = static_cast<EventCode>(*at_ & 7);
    if (!event.is_status()) return NextWithBytes(event);
    event.index = *at_++ >> 3;
    return true;
  }

 private:
  bool NextWithBytes(Event& event) {
    EventReader reader({at_, static_cast<std::size_t>(end_ - at_)});
    const bool found = reader.Next(event);
    constexpr std::size_t kHead = 3;  // words before the bytes
    const std::size_t words = (event.bytes.size() + sizeof *at_ - 1) / sizeof *at_;
    at_ = found ? at_ + kHead + words : end_;
    return found;
  }

  const std::uint32_t* at_;
  const std::uint32_t* end_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EVENTS_INLINE_EVENT_READER_H_
