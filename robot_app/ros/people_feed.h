// Brings the people of /people to the trees, as seen from the robot.
#ifndef COPPICE_ROBOT_APP_ROS_PEOPLE_FEED_H_
#define COPPICE_ROBOT_APP_ROS_PEOPLE_FEED_H_

#include <coppice_msgs/People.h>
#include <ros/node_handle.h>

#include <optional>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/data/inbox.h"
#include "bt_nodes/people/people_view.h"
#include "robot_app/common/transforms/transforms.h"

namespace coppice::robot::adapters {

/// As long as it lives. Where /people is silent, or tf does not know where the robot is, nothing is
/// sent, and what the trees have grows old. If no tree uses the key nothing is subscribed. The
/// clock stamps what arrives.
class PeopleFeed {
 public:
  PeopleFeed(ros::NodeHandle& node, std::vector<Sender<leaves::PeopleView>> trees,
             const Clock& clock);

 private:
  void OnPeople(const coppice_msgs::People& message) const;

  std::vector<Sender<leaves::PeopleView>> trees_;  // those that use it
  const Clock& clock_;
  std::optional<Transforms> transforms_;
  ros::Subscriber subscriber_;
};

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_PEOPLE_FEED_H_
