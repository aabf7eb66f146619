#include "robot_app/common/ros_clock.h"

#include <ros/time.h>

#include <algorithm>

namespace coppice::robot {

Time RosClock::Now() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Time ros = TimeFromNanoseconds(static_cast<std::int64_t>(ros::Time::now().toNSec()));
  if (ros < newest_) ahead_ += newest_ - ros;
  newest_ = ros;
  return ros + ahead_;
}

void RosClock::WaitUntil(Time deadline, WakeUp& wake_up) {
  const Time now = Now();
  if (deadline <= now) return;
  constexpr Duration kSimulatedStep = std::chrono::milliseconds(5);
  constexpr Duration kLongest = std::chrono::seconds(1);
  wake_up.WaitFor(
      std::min<Duration>(deadline - now, ros::Time::isSimTime() ? kSimulatedStep : kLongest));
}

}  // namespace coppice::robot
