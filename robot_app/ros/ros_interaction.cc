#include "robot_app/ros/ros_interaction.h"

#include <std_msgs/String.h>

#include <algorithm>

namespace coppice::robot::adapters {
namespace {

std_msgs::String Message(const std::string& text) {
  std_msgs::String message;
  message.data = text;
  return message;
}

}  // namespace

RosInteraction::RosInteraction(ros::NodeHandle& node)
    : node_(node), speech_(node.advertise<std_msgs::String>("/speech", 10)) {}

void RosInteraction::Say(const std::string& text, Sender<leaves::ActionResult> done) {
  speech_.publish(Message(text));
  const double seconds = std::max(1.0, 0.06 * static_cast<double>(text.size()));
  end_of_speech_ = node_.createTimer(
      ros::Duration(seconds),
      [done](const auto&) {
        done.Send({true, ""});
      },
      true);
}

void RosInteraction::CancelSpeech() { end_of_speech_.stop(); }

}  // namespace coppice::robot::adapters
