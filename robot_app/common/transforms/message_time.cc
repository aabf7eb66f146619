#include "robot_app/common/transforms/message_time.h"

#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace coppice::robot {
namespace {

constexpr double kAhead = 10;      // s
constexpr double kOld = 60;        // s
constexpr double kBelieved = 0.5;  // s ahead
constexpr std::uint32_t kSecond = 1'000'000'000;

}  // namespace

bool IsOfTheFuture(const ros::Time& stamp, const ros::Time& now) {
  return stamp.nsec >= kSecond || stamp.toSec() > now.toSec() + kAhead;
}

Outcome CheckStamp(const ros::Time& stamp, const ros::Time& now) {
  if (stamp.nsec >= kSecond) return Problem{"its stamp is none: more than a second of nanoseconds"};
  const double age = now.toSec() - stamp.toSec();
  if (!IsOfTheFuture(stamp, now) && age <= kOld) return {};
  char text[80];
  std::snprintf(text, sizeof text, "its stamp is %.3g s %s", std::abs(age),
                age < 0 ? "ahead of now" : "old");
  return Problem{text};
}

ros::Time BelievedStamp(const ros::Time& stamp, const ros::Time& now) {
  return std::min(stamp, now + ros::Duration(kBelieved));
}

std::optional<double> StampOfNow(const std_msgs::Header& header, const std::string& topic) {
  const ros::Time now = ros::Time::now();
  const Outcome checked = CheckStamp(header.stamp, now);
  if (checked) return BelievedStamp(header.stamp, now).toSec();
  ROS_WARN_THROTTLE(10, "a message on %s is not used: %s", topic.c_str(),
                    checked.problem().c_str());
  return std::nullopt;
}

}  // namespace coppice::robot
