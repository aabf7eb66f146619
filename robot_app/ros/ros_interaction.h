// Interaction on the action /speak of coppice-speech. Where no program speaks, a text is shown on
// /speech (std_msgs/String) for as long as it would take to say it: nobody who is led, or asked to
// open a door, is left because the loudspeaker is.
#ifndef COPPICE_ROBOT_APP_ROS_ROS_INTERACTION_H_
#define COPPICE_ROBOT_APP_ROS_ROS_INTERACTION_H_

#include <coppice_msgs/SpeakAction.h>
#include <ros/node_handle.h>

#include <string>

#include "bt_nodes/interaction/interaction.h"
#include "robot_app/ros/action_port.h"

namespace coppice::robot::adapters {

class RosInteraction : public leaves::Interaction {
 public:
  explicit RosInteraction(ros::NodeHandle& node);

  void Say(const std::string& text, const std::string& language,
           Sender<leaves::ActionResult> done) override;
  void CancelSpeech() override;
  bool has_mouth() { return speak_.is_connected(); }

 private:
  void Show(const std::string& text, Sender<leaves::ActionResult> done);

  ros::NodeHandle node_;
  ros::Publisher shown_;
  ros::Timer end_of_show_;
  ActionPort<coppice_msgs::SpeakAction> speak_;
};

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_ROS_INTERACTION_H_
