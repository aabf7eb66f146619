// What will happen in the world, in the order of time; of the same moment in the order in which it
// was planned.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_WORLD_EVENT_QUEUE_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_WORLD_EVENT_QUEUE_H_

#include <cstdint>
#include <functional>
#include <map>
#include <utility>

#include "bt_core/base/clock.h"

namespace coppice::robot::deployment {

/// Seconds as a duration, rounded to nanoseconds.
inline Duration Seconds(double seconds) {
  return Duration(static_cast<std::int64_t>(seconds * 1e9));
}

class EventQueue {
 public:
  using Event = std::function<void()>;
  using Id = std::pair<Time, std::uint64_t>;

  Id At(Time time, Event event) {
    const Id id{time, next_++};
    events_.emplace(id, std::move(event));
    return id;
  }
  /// One that has happened is none any more.
  void Cancel(const Id& id) { events_.erase(id); }

  Time next() const { return events_.empty() ? kNever : events_.begin()->first.first; }

  /// True if something was due.
  bool RunDue(Time now) {
    bool was_due = false;
    while (next() <= now) {
      const Event event = std::move(events_.begin()->second);
      events_.erase(events_.begin());
      event();
      was_due = true;
    }
    return was_due;
  }

 private:
  std::map<Id, Event> events_;
  std::uint64_t next_ = 1;
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_WORLD_EVENT_QUEUE_H_
