// Which one of several sources of velocity commands drives the robot: the most important one that
// has something to say. Time is handed in. Not for several threads.
#ifndef COPPICE_ROBOT_APP_TELEOPERATION_VELOCITY_MUX_H_
#define COPPICE_ROBOT_APP_TELEOPERATION_VELOCITY_MUX_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "bt_core/base/clock.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot::teleoperation {

class VelocityMux {
 public:
  /// For each source, the most important one first, how long a command of it counts.
  explicit VelocityMux(std::vector<Duration> timeouts);

  /// A command has come. True: it goes to the base; false: a more important source has the wheel.
  bool Offer(std::size_t source, const Velocity2D& command, Time now);

  /// True once when the source that has the wheel has fallen silent while the robot may move: zero
  /// must go to the base. Call it many times a second.
  bool MustStop(Time now);

  /// The source that has the wheel; nothing if none has.
  std::optional<std::size_t> active(Time now) const;

 private:
  struct Source {
    Duration timeout{0};
    Time counts_until{};
  };
  std::vector<Source> sources_;
  std::size_t last_ = 0;  // whose command went to the base last
  bool moves_ = false;    // that command was not zero
};

}  // namespace coppice::robot::teleoperation

#endif  // COPPICE_ROBOT_APP_TELEOPERATION_VELOCITY_MUX_H_
