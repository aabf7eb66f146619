// ROS time as a Clock: the computer's time, or /clock when use_sim_time is set.
#ifndef COPPICE_ROBOT_APP_COMMON_ROS_CLOCK_H_
#define COPPICE_ROBOT_APP_COMMON_ROS_CLOCK_H_

#include <mutex>

#include "bt_core/base/clock.h"

namespace coppice::robot {

/// Needs ros::init and a NodeHandle. Any thread. Where ROS time goes back (a simulator that was
/// restarted, a computer whose clock was set), this clock goes on from where it was: what a tree
/// has measured stays what it was.
class RosClock : public Clock {
 public:
  Time Now() const override;

  /// With simulated time nobody says when the next /clock comes, so a wait looks every 5 ms of real
  /// time.
  void WaitUntil(Time deadline, WakeUp& wake_up) override;

 private:
  mutable std::mutex mutex_;           // of the rest
  mutable Time newest_ = Time::min();  // that ROS has said
  mutable Duration ahead_{0};          // of ROS time
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_ROS_CLOCK_H_
