// Interaction on a topic: what is spoken on /speech (std_msgs/String). Speaking takes 60 ms of ROS time for each character, at least one second.
#ifndef COPPICE_ROBOT_APP_ROS_ROS_INTERACTION_H_
#define COPPICE_ROBOT_APP_ROS_ROS_INTERACTION_H_

#include <ros/node_handle.h>

#include <string>

#include "bt_nodes/interaction/interaction.h"

namespace coppice::robot::adapters {

class RosInteraction : public leaves::Interaction {
 public:
  explicit RosInteraction(ros::NodeHandle& node);

  void Say(const std::string& text, Sender<leaves::ActionResult> done) override;
  void CancelSpeech() override;

 private:
  ros::NodeHandle node_;
  ros::Publisher speech_;
  ros::Timer end_of_speech_;
};

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_ROS_INTERACTION_H_
