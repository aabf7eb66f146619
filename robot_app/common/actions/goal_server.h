// An action server that works on one goal at a time: the one that comes last. The one before it is
// told that it was cancelled.
//
// actionlib's SimpleActionServer goes by the stamps of goals. Where ROS time has gone back (a
// simulator that was restarted, a computer whose clock was set) it cancels each goal until the time
// of the last one has come again, and so long the robot stands. Here what comes later is newer.
//
//   GoalServer<move_base_msgs::MoveBaseAction> server(
//       node, "move_base", [](const auto& goal) { ... }, [&] { server.Cancel({}, "cancelled"); });
//   server.Start();
//
// For the thread that spins, with one spinner thread.
#ifndef COPPICE_ROBOT_APP_COMMON_ACTIONS_GOAL_SERVER_H_
#define COPPICE_ROBOT_APP_COMMON_ACTIONS_GOAL_SERVER_H_

#include <ros/node_handle.h>

#include <functional>
#include <string>
#include <utility>

#include "robot_app/common/actions/patient_server.h"

namespace coppice::robot {

template <class ActionSpec>
class GoalServer {
 public:
  using Goal = typename ActionSpec::_action_goal_type::_goal_type;
  using Result = typename ActionSpec::_action_result_type::_result_type;
  using Feedback = typename ActionSpec::_action_feedback_type::_feedback_type;

  /// `on_goal`: a new goal, active from now on; it may be ended at once. `on_cancel`: the active
  /// one is no longer wanted, and is still to be ended by Cancel().
  GoalServer(ros::NodeHandle node, const std::string& name,
             std::function<void(const Goal&)> on_goal, std::function<void()> on_cancel)
      : on_goal_(std::move(on_goal)),
        on_cancel_(std::move(on_cancel)),
        server_(
            std::move(node), name, [this](Handle goal) { OnGoal(goal); },
            [this](Handle goal) { OnCancel(goal); }) {}

  /// Takes goals from now on.
  void Start() { server_.start(); }

  bool is_active() const {
    if (!goal_.isValid()) return false;
    const auto status = goal_.getGoalStatus().status;
    return status == actionlib_msgs::GoalStatus::ACTIVE ||
           status == actionlib_msgs::GoalStatus::PREEMPTING;
  }

  /// How the active goal ended.
  void Succeed(const Result& result, const std::string& text) { goal_.setSucceeded(result, text); }
  void Abort(const Result& result, const std::string& text) { goal_.setAborted(result, text); }
  void Cancel(const Result& result, const std::string& text) { goal_.setCanceled(result, text); }

  /// About the active goal.
  void Publish(const Feedback& feedback) { goal_.publishFeedback(feedback); }

 private:
  using Handle = typename PatientServer<ActionSpec>::Handle;

  void OnGoal(Handle goal) {
    if (is_active()) goal_.setCanceled(Result(), "another goal has come");
    goal_ = goal;
    goal_.setAccepted();
    const auto wanted = goal_.getGoal();
    on_goal_(*wanted);
  }
  void OnCancel(Handle goal) {
    if (is_active() && goal == goal_) on_cancel_();
  }

  const std::function<void(const Goal&)> on_goal_;
  const std::function<void()> on_cancel_;
  PatientServer<ActionSpec> server_;
  Handle goal_;  // the last one
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_ACTIONS_GOAL_SERVER_H_
