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

/// Up to the end, or to words that are cut off. `on_statuses(at, end)` takes the resets and results
/// that stand at `at` one behind the other, and returns where they end; `on_other` gets all other
/// events.
template <class OnStatuses, class OnOther>
void ForEachRun(EventWords words, OnStatuses on_statuses, OnOther on_other) {
  const std::uint32_t* at = words.data;
  const std::uint32_t* const end = at + words.size;
  while ((at = on_statuses(at, end)) != end) {
    EventReader reader({at, static_cast<std::size_t>(end - at)});
    Event event;
    if (!reader.Next(event)) return;
    constexpr std::size_t kHead = 3;  // words before the bytes
    at += kHead + (event.bytes.size() + sizeof *at - 1) / sizeof *at;
    on_other(event);
  }
}

/// The same; `on_status` gets one reset (kIdle) or result.
template <class OnStatus, class OnOther>
void ForEachEvent(EventWords words, OnStatus on_status, OnOther on_other) {
  const auto on_statuses = [&on_status](const std::uint32_t* at, const std::uint32_t* end) {
    for (; at != end; ++at) {
      const std::uint32_t code = *at & 7;
      if (code - 1 < static_cast<std::uint32_t>(EventCode::kSkipped)) {
        on_status(NodeIndex(*at >> 3), static_cast<Status>(code));
      } else if (code == 0) {  // apart, since many do nothing then
        on_status(NodeIndex(*at >> 3), Status::kIdle);
      } else {
        break;
      }
    }
    return at;
  };
  ForEachRun(words, on_statuses, on_other);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EVENTS_FOR_EACH_EVENT_H_
