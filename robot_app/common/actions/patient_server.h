// actionlib's ActionServer, which a cancellation with a wrong time does not silence.
//
// actionlib cancels all goals that bear an earlier time than any cancellation before: who cancels
// with a clock that is an hour ahead would keep the robot from whatever it does for an hour. And it
// remembers for ever what it is to cancel as soon as it comes, if the message bears no time, as
// those of actionlib's own clients do not. Here a cancellation is of the past within a second.
//
// For the thread that spins.
#ifndef COPPICE_ROBOT_APP_COMMON_ACTIONS_PATIENT_SERVER_H_
#define COPPICE_ROBOT_APP_COMMON_ACTIONS_PATIENT_SERVER_H_

#include <actionlib/server/action_server.h>
#include <ros/node_handle.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace coppice::robot {

template <class ActionSpec>
class PatientServer : public actionlib::ActionServer<ActionSpec> {
 public:
  using Base = actionlib::ActionServer<ActionSpec>;
  using Handle = typename Base::GoalHandle;

  /// Takes goals from start() on.
  PatientServer(ros::NodeHandle node, const std::string& name, std::function<void(Handle)> on_goal,
                std::function<void(Handle)> on_cancel)
      : Base(node, name, std::move(on_goal), std::move(on_cancel), false),
        timer_(node.createWallTimer(ros::WallDuration(kPeriod),
                                    [this](const ros::WallTimerEvent&) { EndWhatLasts(); })) {}

 private:
  static constexpr double kPeriod = 1;  // s

  void EndWhatLasts() {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    const ros::Time now = ros::Time::now();
    this->last_cancel_ = std::min(this->last_cancel_, now);
    for (auto& goal : this->status_list_) {
      const ros::Time since = goal.handle_destruction_time_;
      const bool lasts = since == ros::Time() || since > now;
      if (lasts && goal.handle_tracker_.expired()) goal.handle_destruction_time_ = now;
    }
  }

  ros::WallTimer timer_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_ACTIONS_PATIENT_SERVER_H_
