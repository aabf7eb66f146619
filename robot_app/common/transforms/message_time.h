// Whether a message may bear the time that it bears. Clocks of sensors and of other computers are
// set wrongly, jump, or are not there at all: who calculates with such a time places the robot
// elsewhere, waits for a day that never comes, or ends, as ros::Time does where it overflows.
#ifndef COPPICE_ROBOT_APP_COMMON_TRANSFORMS_MESSAGE_TIME_H_
#define COPPICE_ROBOT_APP_COMMON_TRANSFORMS_MESSAGE_TIME_H_

#include <ros/time.h>
#include <std_msgs/Header.h>

#include <optional>
#include <string>

#include "bt_core/base/outcome.h"

namespace coppice::robot {

/// A stamp that is none, or more than 10 s ahead of `now`: by so much clocks may differ.
bool IsOfTheFuture(const ros::Time& stamp, const ros::Time& now);

/// A problem if it is of the future, or more than 60 s old.
Outcome CheckStamp(const ros::Time& stamp, const ros::Time& now);

/// What `stamp` counts as: nothing was measured in the future, so whatever is ahead of `now` is
/// ahead by half a second at the most. Or a sensor whose clock is ahead would be believed to see
/// for as long after it has fallen silent.
ros::Time BelievedStamp(const ros::Time& stamp, const ros::Time& now);

/// What the stamp of a message counts as that has just come on a topic [s]; nothing if CheckStamp
/// has a problem with it: a warning was given, now and then. For the thread that spins.
std::optional<double> StampOfNow(const std_msgs::Header& header, const std::string& topic);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_TRANSFORMS_MESSAGE_TIME_H_
