#include "robot_app/monitoring/power/power_messages.h"

namespace coppice::robot::monitoring {

std::vector<GoalReport> FromMessage(const actionlib_msgs::GoalStatusArray& message) {
  std::vector<GoalReport> goals;
  for (const actionlib_msgs::GoalStatus& goal : message.status_list) {
    goals.push_back({goal.goal_id.id, static_cast<GoalPhase>(goal.status), goal.text});
  }
  return goals;
}

}  // namespace coppice::robot::monitoring
