// What EventReader does, for those who read every event of every tick: a status, which nearly all
// words are, costs no call and goes through no Event.
//
//   ForEachEvent(
//       events.words, [&](NodeIndex node, Status status) { ... }, [&](const Event& event) { ... });
#ifndef COPPICE_BT_CORE_ENGINE_EVENTS_FOR_EACH_EVENT_H_
#define COPPICE_BT_CORE_ENGINE_EVENTS_FOR_EACH_EVENT_H_

#include <cstddef>
#include <cstdint>

#include "bt_core/engine/events/event_words.h"

namespace coppice {

/// Up to the end, or to words that are cut off. `on_status` gets resets (kIdle) and results,
/// `on_other` all other events.
template <class OnStatus, class OnOther>
void ForEachEvent(EventWords words, OnStatus on_status, OnOther on_other) {
  const std::uint32_t* const end = words.data + words.size;
  for (const std::uint32_t* at = words.data; at != end;) {
    const std::uint32_t code = *at & 7;
    if (code <= static_cast<std::uint32_t>(EventCode::kSkipped)) {
      on_status(NodeIndex(*at++ >> 3), static_cast<Status>(code));
      continue;
    }
    EventReader reader({at, static_cast<std::size_t>(end - at)});
    Event event;
    if (!reader.Next(event)) return;
    constexpr std::size_t kHead = 3;  // words before the bytes
    at += kHead + (event.bytes.size() + sizeof *at - 1) / sizeof *at;
    on_other(event);
  }
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EVENTS_FOR_EACH_EVENT_H_
