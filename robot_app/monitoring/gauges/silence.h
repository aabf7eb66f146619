// How long nothing has been heard of something, in ROS time or in wall time, whichever is less.
//
// A program does not get more of the processor when simulated time runs fast: at six times real
// time a hiccup of half a second looks like a silence of three. When simulated time is slow, all
// that it stamps is slow as well. In real time both are the same.
#ifndef COPPICE_ROBOT_APP_MONITORING_GAUGES_SILENCE_H_
#define COPPICE_ROBOT_APP_MONITORING_GAUGES_SILENCE_H_

#include <algorithm>
#include <optional>

#include "robot_app/monitoring/gauges/finding.h"

namespace coppice::robot::monitoring {

enum class SilenceIn {
  kEitherTime,  ///< whichever is less
  kRosTime,
};

class Silence {
 public:
  explicit Silence(SilenceIn time = SilenceIn::kEitherTime) : time_(time) {}

  void OnMessage(const Times& now) { heard_ = now; }
  void Reset() { heard_.reset(); }

  /// Counts from the first call if nothing was heard before. ROS time that was set back begins
  /// anew.
  Duration Lasted(const Times& now) {
    if (!heard_ || now.ros < heard_->ros) heard_ = now;
    const Duration in_ros_time = now.ros - heard_->ros;
    return time_ == SilenceIn::kRosTime ? in_ros_time
                                        : std::min(in_ros_time, now.wall - heard_->wall);
  }

 private:
  SilenceIn time_;
  std::optional<Times> heard_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_GAUGES_SILENCE_H_
