#include "robot_app/ros/ros_navigator.h"

#include <coppice_msgs/DockingAction.h>
#include <coppice_msgs/MotionAction.h>
#include <move_base_msgs/MoveBaseAction.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "robot_app/ros/action_port.h"

namespace coppice::robot::adapters {
namespace {

using leaves::ActionResult;

// Results of our own servers carry a message of their own.
template <class Result>
ActionResult FromResult(const actionlib::TerminalState& state, const Result* result) {
  ActionResult answer = FromGoalState(state);
  if (answer.ok && result) answer = {static_cast<bool>(result->ok), result->message};
  if (!answer.ok && result && !result->message.empty()) answer.message = result->message;
  return answer;
}

class RosNavigator : public leaves::Navigator {
 public:
  explicit RosNavigator(ros::NodeHandle& node)
      : move_base_(node, "move_base",
                   [](const auto& state, const auto*) { return FromGoalState(state); }),
        motion_(node, "motion",
                [](const auto& state, const auto* result) { return FromResult(state, result); }) {}

  void NavigateTo(const leaves::Pose2D& goal, Sender<ActionResult> done) override {
    move_base_msgs::MoveBaseGoal message;
    message.target_pose.header.frame_id = "map";
    message.target_pose.header.stamp = ros::Time::now();
    message.target_pose.pose.position.x = goal.x;
    message.target_pose.pose.position.y = goal.y;
    message.target_pose.pose.orientation.z = std::sin(goal.yaw / 2);
    message.target_pose.pose.orientation.w = std::cos(goal.yaw / 2);
    move_base_.Start(message, done);
  }
  void CancelNavigation() override { move_base_.Cancel(); }

  void Move(double distance, double speed, Sender<ActionResult> done) override {
    coppice_msgs::MotionGoal goal;
    goal.distance = distance;
    goal.speed = speed;
    motion_.Start(goal, done);
  }
  void Rotate(double angle, double speed, Sender<ActionResult> done) override {
    coppice_msgs::MotionGoal goal;
    goal.angle = angle;
    goal.speed = speed;
    motion_.Start(goal, done);
  }
  void CancelMotion() override { motion_.Cancel(); }

 private:
  ActionPort<move_base_msgs::MoveBaseAction> move_base_;
  ActionPort<coppice_msgs::MotionAction> motion_;
};

class RosChargingStation : public leaves::ChargingStation {
 public:
  explicit RosChargingStation(ros::NodeHandle& node)
      : docking_(node, "docking",
                 [](const auto& state, const auto* result) { return FromResult(state, result); }) {}

  void Dock(double lateral_offset, int attempts, Sender<ActionResult> done) override {
    coppice_msgs::DockingGoal goal;
    goal.dock = true;
    goal.lateral_offset = lateral_offset;
    goal.attempts = static_cast<std::uint8_t>(std::clamp(attempts, 0, 255));
    docking_.Start(goal, done);
  }
  void PressOn(Sender<ActionResult> done) override {
    coppice_msgs::DockingGoal goal;
    goal.press_on = true;
    docking_.Start(goal, done);
  }
  void Undock(Sender<ActionResult> done) override {
    docking_.Start(coppice_msgs::DockingGoal(), done);
  }
  void CancelDocking() override { docking_.Cancel(); }

 private:
  ActionPort<coppice_msgs::DockingAction> docking_;
};

}  // namespace

std::unique_ptr<leaves::Navigator> MakeRosNavigator(ros::NodeHandle& node) {
  return std::make_unique<RosNavigator>(node);
}

std::unique_ptr<leaves::ChargingStation> MakeRosChargingStation(ros::NodeHandle& node) {
  return std::make_unique<RosChargingStation>(node);
}

}  // namespace coppice::robot::adapters
