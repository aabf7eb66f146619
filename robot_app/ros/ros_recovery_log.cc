#include "robot_app/ros/ros_recovery_log.h"

#include <coppice_msgs/RecoveryEvent.h>
#include <ros/console.h>

#include <algorithm>
#include <cstdint>

namespace coppice::robot::adapters {
namespace {

using Message = coppice_msgs::RecoveryEvent;

ros::Time ToRos(Time time) {
  ros::Time stamp;
  return stamp.fromNSec(static_cast<std::uint64_t>(std::max<std::int64_t>(0, ToNanoseconds(time))));
}

Message ToMessage(const leaves::RecoveryEvent& event) {
  Message message;
  message.header.stamp = ToRos(event.time);
  message.recovery = event.recovery;
  message.subject = event.subject;
  message.phase = static_cast<std::uint8_t>(event.phase);  // numbered alike
  message.attempt = static_cast<std::uint32_t>(event.attempt);
  message.message = event.message;
  if (event.pose) {
    message.header.frame_id = "map";
    message.x = event.pose->x;
    message.y = event.pose->y;
    message.yaw = event.pose->yaw;
  }
  return message;
}

}  // namespace

RosRecoveryLog::RosRecoveryLog(ros::NodeHandle& node, const Clock& clock)
    : clock_(clock),
      events_(node.advertise<Message>("/recovery/events", 100)),
      timer_(node.createWallTimer(ros::WallDuration(1), [this](const auto&) { OnTimer(); })) {}

void RosRecoveryLog::Record(const leaves::RecoveryEvent& event) {
  ROS_INFO_STREAM("recovery \"" << event.recovery << "\" of " << event.subject << ", attempt "
                                << event.attempt << ": " << ToString(event.phase)
                                << (event.message.empty() ? "" : "; " + event.message));
  events_.publish(ToMessage(event));
  const std::lock_guard<std::mutex> lock(mutex_);
  Publish(judge_.Take(event));
}

void RosRecoveryLog::Publish(const std::vector<leaves::RecoveryVerdict>& verdicts) {
  for (const leaves::RecoveryVerdict& verdict : verdicts) {
    Message message;
    message.header.stamp = ToRos(clock_.Now());
    message.recovery = verdict.recovery;
    message.subject = verdict.subject;
    message.attempt = static_cast<std::uint32_t>(verdict.attempt);
    message.phase = verdict.helped ? Message::HELPED : Message::DID_NOT_HELP;
    events_.publish(message);
  }
}

void RosRecoveryLog::OnTimer() {
  const std::lock_guard<std::mutex> lock(mutex_);
  Publish(judge_.Advance(clock_.Now()));
}

}  // namespace coppice::robot::adapters
