// The recording of the Groot2 protocol: changes of status with their times, as bytes that the
// client fetches. The oldest are dropped when nobody does, and counted.
#ifndef COPPICE_BT_CORE_LIVE_GROOT2_TRANSITIONS_H_
#define COPPICE_BT_CORE_LIVE_GROOT2_TRANSITIONS_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "bt_core/engine/events.h"
#include "bt_core/engine/events/status_follower.h"

namespace coppice {

class Transitions {
 public:
  static constexpr std::size_t kDefaultLimit = 1 << 20;

  explicit Transitions(std::size_t limit = kDefaultLimit) : limit_(limit) {}

  /// Forgets what there is and records from here on. `now` is what times are counted from, in the
  /// clock of the tree.
  void Start(const StatusFollower& statuses, Time now);
  void Stop() { statuses_.reset(); }
  bool is_recording() const { return statuses_.has_value(); }

  /// While recording. All changes of a tick bear the time of its start.
  void Add(const TickEvents& events);
  /// The tree is another one, or its state is.
  void Jump(const StatusFollower& statuses);

  /// Nine bytes for each transition, the oldest first: microseconds (6), number of the node in the
  /// protocol (2), status (1), little endian. They are kept no longer.
  std::string Take();

  /// Transitions that were not fetched in time, since Start.
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct Transition {
    std::uint64_t microseconds;
    NodeIndex node;
    Status status;
  };

  void Add(const Transition& transition);

  const std::size_t limit_;
  std::optional<StatusFollower> statuses_;
  std::deque<Transition> transitions_;
  Time start_{};
  std::uint64_t dropped_ = 0;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_GROOT2_TRANSITIONS_H_
