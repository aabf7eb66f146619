#include "robot_app/ros/ros_navigator.h"

#include <actionlib/server/simple_action_server.h>
#include <gtest/gtest.h>
#include <move_base_msgs/MoveBaseAction.h>

#include <atomic>

#include "bt_core/testing/leaf_harness.h"
#include "bt_nodes/navigation/navigation_leaves.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot {
namespace {

using Server = actionlib::SimpleActionServer<move_base_msgs::MoveBaseAction>;

class RosNavigatorTest : public testing::Test {
 protected:
  RosNavigatorTest() { harness_.Set("goal", Pose2D{1, 2, 0}); }

  // A move_base that ends every goal as told, or works until it is pre-empted.
  std::unique_ptr<Server> StartServer(std::function<void(Server&)> end) {
    auto server = std::make_unique<Server>(node_, "move_base", false);
    Server* raw = server.get();
    server->registerGoalCallback([raw, end] {
      const auto goal = raw->acceptNewGoal();
      EXPECT_EQ(goal->target_pose.pose.position.x, 1);
      EXPECT_EQ(goal->target_pose.header.frame_id, "map");
      end(*raw);
    });
    server->start();
    return server;
  }
  bool EndsWith(Status status, double seconds = 10) {
    return Eventually([&] { return harness_.Tick() == status; }, seconds);
  }

  ros::NodeHandle node_;
  std::unique_ptr<Navigator> navigator_ = MakeRosNavigator(node_);
  LeafHarness harness_ = LeafHarness::For<NavigateTo>(std::ref(*navigator_));
};

TEST_F(RosNavigatorTest, SucceedsWhenMoveBaseDoes) {
  const auto server = StartServer([](Server& s) { s.setSucceeded(); });
  EXPECT_TRUE(EndsWith(Status::kSuccess));
}

TEST_F(RosNavigatorTest, FailsWithTheTextOfMoveBase) {
  const auto server =
      StartServer([](Server& s) { s.setAborted(move_base_msgs::MoveBaseResult(), "no path"); });
  // A status that the server sent before it had the goal, but which comes after, makes actionlib
  // call the goal lost. Then the next one tells.
  EXPECT_TRUE(Eventually(
      [&] { return harness_.Tick() == Status::kFailure && harness_.message() == "no path"; }, 10));
}

TEST_F(RosNavigatorTest, CancelsTheGoalWhenHalted) {
  std::atomic<bool> accepted{false};
  const auto server = StartServer([&](Server&) { accepted = true; });
  harness_.Tick();
  ASSERT_TRUE(Eventually([&] { return accepted.load(); }));
  harness_.Halt();
  EXPECT_TRUE(Eventually([&] { return server->isPreemptRequested(); }));
}

TEST_F(RosNavigatorTest, SaysThatTheServerDiedWhileDriving) {
  std::atomic<bool> accepted{false};
  auto server = StartServer([&](Server&) { accepted = true; });
  harness_.Tick();
  ASSERT_TRUE(Eventually([&] { return accepted.load(); }));
  server.reset();
  EXPECT_TRUE(EndsWith(Status::kFailure));
  EXPECT_EQ(harness_.message(), "action server \"move_base\" is gone");
}

TEST_F(RosNavigatorTest, SaysThatThereIsNoServer) {
  EXPECT_TRUE(EndsWith(Status::kFailure, 20));
  EXPECT_EQ(harness_.message(), "no action server \"move_base\"");
}

}  // namespace
}  // namespace coppice::robot
