#include "robot_app/monitoring/power/power_messages.h"

#include <gtest/gtest.h>

namespace coppice::robot::monitoring {
namespace {

TEST(PowerMessages, GoalsKeepTheirIdsAndPhases) {
  using Status = actionlib_msgs::GoalStatus;
  EXPECT_EQ(static_cast<int>(GoalPhase::kActive), +Status::ACTIVE);
  EXPECT_EQ(static_cast<int>(GoalPhase::kPreempted), +Status::PREEMPTED);
  EXPECT_EQ(static_cast<int>(GoalPhase::kSucceeded), +Status::SUCCEEDED);
  EXPECT_EQ(static_cast<int>(GoalPhase::kAborted), +Status::ABORTED);
  EXPECT_EQ(static_cast<int>(GoalPhase::kRejected), +Status::REJECTED);
  EXPECT_EQ(static_cast<int>(GoalPhase::kPreempting), +Status::PREEMPTING);
  EXPECT_EQ(static_cast<int>(GoalPhase::kRecalling), +Status::RECALLING);
  EXPECT_EQ(static_cast<int>(GoalPhase::kRecalled), +Status::RECALLED);
  EXPECT_EQ(static_cast<int>(GoalPhase::kLost), +Status::LOST);
  actionlib_msgs::GoalStatusArray message;
  message.status_list.resize(2);
  message.status_list[1].goal_id.id = "second";
  message.status_list[1].status = Status::ABORTED;
  message.status_list[1].text = "no current";
  const auto goals = FromMessage(message);
  ASSERT_EQ(goals.size(), 2u);
  EXPECT_EQ(goals[1].id, "second");
  EXPECT_EQ(goals[1].phase, GoalPhase::kAborted);
  EXPECT_EQ(goals[1].message, "no current");
}

}  // namespace
}  // namespace coppice::robot::monitoring
