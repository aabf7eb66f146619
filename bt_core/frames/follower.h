// Knows how a tree stands from its history: statuses, last statuses and values.
#ifndef COPPICE_BT_CORE_FRAMES_FOLLOWER_H_
#define COPPICE_BT_CORE_FRAMES_FOLLOWER_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/engine/events/for_each_event.h"
#include "bt_core/engine/events/status_follower.h"
#include "bt_core/frames/history.h"

namespace coppice {

class HistoryFollower {
 public:
  HistoryFollower(TreeShape shape, const HistoryState& state);

  /// Becomes what the state says.
  void Set(const HistoryState& state);
  void Apply(const TickEvents& events);
  /// The same for events of an executor; what follows from those of a whole tick is worked out by
  /// Settle, which has to be called before a status is asked for.
  void Note(const TickEvents& events);
  void Settle();
  /// Applies the same events as the last Apply or ApplyAgain. True if that changed nothing: then
  /// they never will, as long as no others come, and Pass is enough for the ticks to come.
  bool ApplyAgain(const TickEvents& events);
  /// Instead of Apply: only that there was a tick.
  void Pass(const TickEvents& events) {
    tick_ = events.tick;
    time_ = events.start;
  }
  /// The same; `on_change` is called with every StatusChange, `on_event` with every Event before
  /// it is applied.
  template <class OnChange, class OnEvent>
  void Apply(const TickEvents& events, OnChange on_change, OnEvent on_event);

  std::uint64_t tick() const { return tick_; }
  Time time() const { return time_; }
  Status status(NodeIndex node) const { return statuses_.status(node); }
  const std::vector<Status>& statuses() const { return statuses_.statuses(); }
  /// The last status of a node that was not IDLE; kIdle: not known.
  Status last(NodeIndex node) const { return statuses_.last(node); }
  /// Per slot, as in data/value_bytes.h; an empty string is a value that was never written.
  const std::vector<std::string>& values() const { return values_; }

  HistoryState State(HistoryState::Cause cause) const;

  /// The last statuses if the statuses were these.
  std::vector<Status> LastsWith(const std::vector<Status>& statuses) const;

 private:
  void ApplyWrite(const Event& event);

  StatusFollower statuses_;
  std::uint64_t tick_ = 0;
  Time time_{};
  std::vector<std::string> values_;
  bool is_noted_ = false;  // something that is not settled
};

template <class OnChange, class OnEvent>
void HistoryFollower::Apply(const TickEvents& events, OnChange on_change, OnEvent on_event) {
  Pass(events);
  Settle();
  ForEachEvent(
      events.words,
      [&](NodeIndex node, Status status) {
        Event event;
        event.code = static_cast<EventCode>(status);
        event.index = node;
        on_event(event);
        statuses_.Apply(event, on_change);
      },
      [&](const Event& event) {
        on_event(event);
        ApplyWrite(event);
      });
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_FOLLOWER_H_
