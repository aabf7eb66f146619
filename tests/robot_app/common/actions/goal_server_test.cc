#include "robot_app/common/actions/goal_server.h"

#include <gtest/gtest.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/callback_queue.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/robot_app/eventually.h"

namespace coppice::robot {
namespace {

using actionlib_msgs::GoalStatus;

// The server and a client by its topics, both in the thread of the test.
class GoalServerTest : public testing::Test {
 protected:
  // `remembers`: how long the server tells of goals that have ended [s].
  explicit GoalServerTest(double remembers = 5) {
    node_.setCallbackQueue(&queue_);
    node_.setParam("walk/status_list_timeout", remembers);
    server_.emplace(
        node_, "walk",
        [this](const move_base_msgs::MoveBaseGoal& goal) {
          taken_.push_back(goal.target_pose.pose.position.x);
          if (taken_.back() < 0) server_->Abort({}, "no such place");
        },
        [this] { server_->Cancel({}, "cancelled"); });
    server_->Start();
    goals_ = node_.advertise<move_base_msgs::MoveBaseActionGoal>("walk/goal", 10);
    cancels_ = node_.advertise<actionlib_msgs::GoalID>("walk/cancel", 10);
    results_ = node_.subscribe<move_base_msgs::MoveBaseActionResult>(
        "walk/result", 10, [this](const move_base_msgs::MoveBaseActionResult::ConstPtr& result) {
          ends_[result->status.goal_id.id] = result->status.status;
        });
    states_ = node_.subscribe<actionlib_msgs::GoalStatusArray>(
        "walk/status", 10, [this](const actionlib_msgs::GoalStatusArray::ConstPtr& state) {
          told_of_ = state->status_list.size();
        });
    EXPECT_TRUE(Until([this] {
      return goals_.getNumSubscribers() > 0 && cancels_.getNumSubscribers() > 0 &&
             results_.getNumPublishers() > 0;
    }));
  }

  bool Until(const std::function<bool()>& is_true) {
    return Eventually([&] {
      queue_.callAvailable();
      return is_true();
    });
  }
  // To x [m], as a client sends it at that time [s].
  void Send(const std::string& name, double x, double stamp) {
    const std::size_t before = taken_.size();
    move_base_msgs::MoveBaseActionGoal goal;
    goal.goal_id.id = name;
    goal.goal_id.stamp = ros::Time(stamp);
    goal.goal.target_pose.pose.position.x = x;
    goals_.publish(goal);
    EXPECT_TRUE(Until([&] { return taken_.size() > before; })) << name;
    EXPECT_EQ(taken_.back(), x);
  }
  bool EndsAs(const std::string& name, int status) {
    return Until([&] { return ends_.count(name) > 0; }) && ends_[name] == status;
  }

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  std::vector<double> taken_;
  std::map<std::string, int> ends_;  // by the names of the goals
  std::size_t told_of_ = 0;          // goals, last
  std::optional<GoalServer<move_base_msgs::MoveBaseAction>> server_;
  ros::Publisher goals_, cancels_;
  ros::Subscriber results_, states_;
};

TEST_F(GoalServerTest, EndsAGoalAsItIsTold) {
  EXPECT_FALSE(server_->is_active());
  Send("first", 1, 10);
  EXPECT_TRUE(server_->is_active());
  server_->Succeed({}, "there");
  EXPECT_FALSE(server_->is_active());
  EXPECT_TRUE(EndsAs("first", GoalStatus::SUCCEEDED));
  Send("second", -1, 11);
  EXPECT_FALSE(server_->is_active());
  EXPECT_TRUE(EndsAs("second", GoalStatus::ABORTED));
}

TEST_F(GoalServerTest, ANewGoalTakesThePlaceOfTheOneBefore) {
  Send("first", 1, 10);
  Send("second", 2, 11);
  EXPECT_TRUE(EndsAs("first", GoalStatus::PREEMPTED));
  server_->Succeed({}, "there");
  EXPECT_TRUE(EndsAs("second", GoalStatus::SUCCEEDED));
}

TEST_F(GoalServerTest, TakesGoalsAfterTimeWentBack) {
  Send("before", 1, 1000);
  server_->Succeed({}, "there");
  Send("after", 2, 10);
  Send("at once", 3, 10);
  EXPECT_TRUE(EndsAs("after", GoalStatus::PREEMPTED));
  EXPECT_TRUE(server_->is_active());
}

TEST_F(GoalServerTest, OnlyTheActiveGoalIsCancelled) {
  Send("first", 1, 10);
  Send("second", 2, 11);
  ASSERT_TRUE(EndsAs("first", GoalStatus::PREEMPTED));
  actionlib_msgs::GoalID id;
  id.id = "first";
  cancels_.publish(id);
  id.id = "second";
  cancels_.publish(id);
  EXPECT_TRUE(EndsAs("second", GoalStatus::PREEMPTED));
  EXPECT_FALSE(server_->is_active());
}

// By somebody whose clock is an hour ahead.
TEST_F(GoalServerTest, TakesGoalsAfterACancellationOfTheFuture) {
  actionlib_msgs::GoalID all;
  all.stamp = ros::Time::now() + ros::Duration(3600);
  Send("first", 1, ros::Time::now().toSec());
  cancels_.publish(all);
  ASSERT_TRUE(EndsAs("first", GoalStatus::PREEMPTED));
  const std::size_t before = taken_.size();
  int goals = 0;
  EXPECT_TRUE(Until([&] {
    move_base_msgs::MoveBaseActionGoal goal;
    goal.goal_id.id = "later" + std::to_string(++goals);
    goal.goal_id.stamp = ros::Time::now();
    goals_.publish(goal);
    return taken_.size() > before;
  }));
}

class GoalServerThatForgetsTest : public GoalServerTest {
 protected:
  GoalServerThatForgetsTest() : GoalServerTest(0.1) {}
};

TEST_F(GoalServerThatForgetsTest, TellsNotForEverOfGoalsThatWereCancelledAndNeverCame) {
  actionlib_msgs::GoalID unknown;
  unknown.id = "of no time";
  cancels_.publish(unknown);
  unknown.id = "of the future";
  unknown.stamp = ros::Time::now() + ros::Duration(3600);
  cancels_.publish(unknown);
  ASSERT_TRUE(Until([&] { return told_of_ == 2; }));
  EXPECT_TRUE(Until([&] { return told_of_ == 0; }));
}

}  // namespace
}  // namespace coppice::robot
