#include "robot_app/ros/ros_navigator.h"

#include <coppice_msgs/DockingAction.h>
#include <coppice_msgs/MotionAction.h>
#include <geometry_msgs/PoseStamped.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nav_msgs/GetPlan.h>
#include <std_msgs/Float64.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "robot_app/common/service_call.h"
#include "robot_app/common/service_caller.h"
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

geometry_msgs::PoseStamped InMap(const leaves::Pose2D& pose) {
  geometry_msgs::PoseStamped message;
  message.header.frame_id = "map";
  message.header.stamp = ros::Time::now();
  message.pose.position.x = pose.x;
  message.pose.position.y = pose.y;
  message.pose.orientation.z = std::sin(pose.yaw / 2);
  message.pose.orientation.w = std::cos(pose.yaw / 2);
  return message;
}

class RosNavigator : public leaves::Navigator {
 public:
  explicit RosNavigator(ros::NodeHandle& node)
      : move_base_(node, "move_base",
                   [](const auto& state, const auto*) { return FromGoalState(state); }),
        motion_(node, "motion",
                [](const auto& state, const auto* result) { return FromResult(state, result); }),
        speed_limit_(node.advertise<std_msgs::Float64>("/navigation/speed_limit", 1)) {}

  void NavigateTo(const leaves::Pose2D& goal, Sender<ActionResult> done) override {
    move_base_msgs::MoveBaseGoal message;
    message.target_pose = InMap(goal);
    move_base_.Start(message, done);
  }
  void CancelNavigation() override { move_base_.Cancel(); }
  void LimitSpeed(double speed) override {
    std_msgs::Float64 message;
    message.data = speed;
    speed_limit_.publish(message);
  }

  void FindWay(const leaves::Pose2D& goal, Sender<ActionResult> done) override {
    const auto ask = [goal = InMap(goal), done]() -> ServiceCaller::Finish {
      nav_msgs::GetPlan plan;
      plan.request.goal = goal;
      const bool found =
          CallService("move_base/make_plan", plan) && !plan.response.plan.poses.empty();
      done.Send({found, found ? "" : "there is no way right now"});
      return [] {};
    };
    plans_.RunFinished();
    if (!plans_.Add(ask)) done.Send({false, "too many ask for ways"});
  }

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
  ros::Publisher speed_limit_;
  ServiceCaller plans_;
};

class RosChargingStation : public leaves::ChargingStation {
 public:
  // A docking that died has not missed the station: to try again from aside would be wrong.
  explicit RosChargingStation(ros::NodeHandle& node)
      : docking_(
            node, "docking",
            [](const auto& state, const auto* result) { return FromResult(state, result); },
            WhenGone::kAsksItsSuccessor) {}

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
