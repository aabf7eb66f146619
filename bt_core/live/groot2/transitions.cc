#include "bt_core/live/groot2/transitions.h"

#include <algorithm>

#include "bt_core/live/groot2/full_tree.h"

namespace coppice {

void Transitions::Start(const StatusFollower& statuses, Time now) {
  statuses_ = statuses;
  transitions_.clear();
  dropped_ = 0;
  start_ = now;
}

void Transitions::Jump(const StatusFollower& statuses) {
  if (is_recording()) statuses_ = statuses;
}

void Transitions::Add(const TickEvents& events) {
  if (!is_recording()) return;
  const Duration since = std::max(events.start - start_, Duration(0));
  const auto microseconds = static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(since).count());
  EventReader reader(events.words);
  for (Event event; reader.Next(event);) {
    statuses_->Apply(event, [&](const StatusChange& change) {
      Add({microseconds, change.node, change.to});
    });
  }
}

void Transitions::Add(const Transition& transition) {
  if (transitions_.size() == limit_) {
    transitions_.pop_front();
    ++dropped_;
  }
  transitions_.push_back(transition);
}

std::string Transitions::Take() {
  std::string bytes;
  bytes.reserve(transitions_.size() * 9);
  for (const Transition& transition : transitions_) {
    for (int shift = 0; shift < 48; shift += 8) {
      bytes += static_cast<char>(transition.microseconds >> shift & 0xff);
    }
    const std::uint16_t uid = Uid(transition.node);
    bytes += static_cast<char>(uid & 0xff);
    bytes += static_cast<char>(uid >> 8);
    bytes += static_cast<char>(transition.status);
  }
  transitions_.clear();
  return bytes;
}

}  // namespace coppice
