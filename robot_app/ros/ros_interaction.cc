#include "robot_app/ros/ros_interaction.h"

#include <std_msgs/String.h>

#include <algorithm>

namespace coppice::robot::adapters {
namespace {

constexpr double kPerByte = 0.06, kLeast = 1.0;  // of a text that is shown, ROS time [s]

leaves::ActionResult ResultOf(const actionlib::TerminalState& state,
                              const coppice_msgs::SpeakResult* result) {
  leaves::ActionResult answer = FromGoalState(state);
  if (!answer.ok && result != nullptr && !result->message.empty()) {
    answer.message = result->message;
  }
  return answer;
}

}  // namespace

RosInteraction::RosInteraction(ros::NodeHandle& node)
    : node_(node),
      shown_(node.advertise<std_msgs::String>("/speech", 10)),
      speak_(node, "/speak", ResultOf) {}

void RosInteraction::Say(const std::string& text, const std::string& language,
                         Sender<leaves::ActionResult> done) {
  if (!has_mouth()) return Show(text, done);
  coppice_msgs::SpeakGoal goal;
  goal.text = text;
  goal.language = language;
  goal.priority = coppice_msgs::SpeakGoal::NORMAL;
  speak_.Start(goal, done);
}

void RosInteraction::Show(const std::string& text, Sender<leaves::ActionResult> done) {
  std_msgs::String message;
  message.data = text;
  shown_.publish(message);
  const double seconds = std::max(kLeast, kPerByte * static_cast<double>(text.size()));
  end_of_show_ = node_.createTimer(
      ros::Duration(seconds),
      [done](const auto&) {
        done.Send({true, ""});
      },
      true);
}

void RosInteraction::CancelSpeech() {
  end_of_show_.stop();
  speak_.Cancel();
}

}  // namespace coppice::robot::adapters
