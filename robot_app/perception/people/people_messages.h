// Tracks as messages: /people for the robot, markers for RViz.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_PEOPLE_MESSAGES_H_
#define COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_PEOPLE_MESSAGES_H_

#include <coppice_msgs/People.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "robot_app/perception/tracking/tracker.h"

namespace coppice::robot::perception {

/// Everybody who is confirmed, in the frame `frame`.
coppice_msgs::People ToMessage(const Tracker& tracker, const std::string& frame);

/// A pillar, a number and an arrow of the velocity for each; transparent while unseen. What was
/// shown before and is not any more goes away by itself.
visualization_msgs::MarkerArray ToMarkers(const coppice_msgs::People& people);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_PEOPLE_MESSAGES_H_
