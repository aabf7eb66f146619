#include "robot_app/ros/ros_navigator.h"

#include <actionlib/server/simple_action_server.h>
#include <coppice_msgs/DockingAction.h>
#include <gtest/gtest.h>
#include <move_base_msgs/MoveBaseAction.h>

#include <atomic>
#include <mutex>
#include <set>
#include <string>

#include "bt_core/testing/leaf_harness.h"
#include "bt_nodes/docking/docking_leaves.h"
#include "bt_nodes/navigation/navigation_leaves.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot::adapters {
namespace {

using Server = actionlib::SimpleActionServer<move_base_msgs::MoveBaseAction>;

class RosNavigatorTest : public testing::Test {
 protected:
  RosNavigatorTest() { harness_.Set("goal", leaves::Pose2D{1, 2, 0}); }

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
  std::unique_ptr<leaves::Navigator> navigator_ = MakeRosNavigator(node_);
  LeafHarness harness_ = LeafHarness::For<leaves::NavigateTo>(std::ref(*navigator_));
};

TEST_F(RosNavigatorTest, SucceedsWhenMoveBaseDoes) {
  const auto server = StartServer([](Server& s) { s.setSucceeded(); });
  EXPECT_TRUE(EndsWith(Status::kSuccess));
}

TEST_F(RosNavigatorTest, FailsWithTheTextOfMoveBase) {
  const auto server =
      StartServer([](Server& s) { s.setAborted(move_base_msgs::MoveBaseResult(), "no path"); });
  EXPECT_TRUE(EndsWith(Status::kFailure));
  EXPECT_EQ(harness_.message(), "no path");
}

// A server by its topics, which says at once that it has forgotten the goals that it took, but for
// the last one, and ends that. Or it does not even take them, as one that hangs.
class ForgetfulServer {
 public:
  ForgetfulServer(ros::NodeHandle& node, int forgets, bool takes = true)
      : forgets_(forgets),
        takes_(takes),
        status_(node.advertise<actionlib_msgs::GoalStatusArray>("move_base/status", 10)),
        feedback_(node.advertise<move_base_msgs::MoveBaseActionFeedback>("move_base/feedback", 1)),
        result_(node.advertise<move_base_msgs::MoveBaseActionResult>("move_base/result", 1)),
        cancel_(node.subscribe("move_base/cancel", 1, &ForgetfulServer::Cancel, this)),
        goal_(node.subscribe<move_base_msgs::MoveBaseActionGoal>(
            "move_base/goal", 10,
            [this](const move_base_msgs::MoveBaseActionGoalConstPtr& goal) {
              Take(goal->goal_id);
            })),
        timer_(node.createWallTimer(ros::WallDuration(0.05), [this](const auto& /*event*/) {
          const std::lock_guard<std::mutex> lock(mutex_);
          if (goals_ == 0 || (!takes_ && goals_ <= forgets_)) {
            status_.publish(actionlib_msgs::GoalStatusArray());
          }
        })) {}
  int goals() const { return goals_; }
  /// Of the goal that came last.
  bool is_cancelled() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return cancelled_.count(last_) > 0;
  }

 private:
  void Cancel(const actionlib_msgs::GoalID& id) {
    const std::lock_guard<std::mutex> lock(mutex_);
    cancelled_.insert(id.id);
  }

  void Take(const actionlib_msgs::GoalID& id) {
    const std::lock_guard<std::mutex> lock(mutex_);
    last_ = id.id;
    if (++goals_ <= forgets_ && !takes_) return;
    actionlib_msgs::GoalStatus taken;
    taken.goal_id = id;
    taken.status = actionlib_msgs::GoalStatus::ACTIVE;
    actionlib_msgs::GoalStatusArray with_goal;
    with_goal.status_list = {taken};
    status_.publish(with_goal);
    if (goals_ <= forgets_) return status_.publish(actionlib_msgs::GoalStatusArray());
    move_base_msgs::MoveBaseActionResult result;
    result.status = taken;
    result.status.status = actionlib_msgs::GoalStatus::SUCCEEDED;
    result_.publish(result);
  }

  const int forgets_;
  const bool takes_;
  std::atomic<int> goals_{0};
  mutable std::mutex mutex_;
  std::string last_;
  std::set<std::string> cancelled_;
  ros::Publisher status_, feedback_, result_;
  ros::Subscriber cancel_, goal_;
  ros::WallTimer timer_;
};

TEST_F(RosNavigatorTest, SendsAGoalAgainThatWasLostAtOnce) {
  const ForgetfulServer server(node_, 1);
  Status status = Status::kRunning;
  EXPECT_TRUE(Eventually([&] { return (status = harness_.Tick()) != Status::kRunning; }, 10));
  EXPECT_EQ(status, Status::kSuccess) << harness_.message();
  EXPECT_EQ(server.goals(), 2);
}

TEST_F(RosNavigatorTest, FailsWhenTheGoalIsLostAgain) {
  const ForgetfulServer server(node_, 100);
  Status status = Status::kRunning;
  EXPECT_TRUE(Eventually([&] { return (status = harness_.Tick()) != Status::kRunning; }, 10));
  EXPECT_EQ(status, Status::kFailure);
  EXPECT_EQ(server.goals(), 2);
}

TEST_F(RosNavigatorTest, SendsAGoalAgainThatWasNeverTaken) {
  const ForgetfulServer server(node_, 1, false);
  EXPECT_TRUE(EndsWith(Status::kSuccess)) << harness_.message();
  EXPECT_EQ(server.goals(), 2);
}

TEST_F(RosNavigatorTest, FailsWhenNobodyTakesTheGoal) {
  const ForgetfulServer server(node_, 100, false);
  EXPECT_TRUE(EndsWith(Status::kFailure, 20));
  EXPECT_EQ(harness_.message(), R"(action server "move_base" does not take the goal)");
  EXPECT_EQ(server.goals(), 2);
  EXPECT_TRUE(Eventually([&] { return server.is_cancelled(); })) << "or it drives there later";
}

// It hears the cancellation of all goals while it knows of none.
TEST_F(RosNavigatorTest, CancelsAGoalThatItsCancellationHasOvertaken) {
  actionlib_msgs::GoalID goal;
  std::atomic<bool> has_goal{false}, has_heard_cancel{false}, is_cancelled{false};
  ros::Publisher status =
      node_.advertise<actionlib_msgs::GoalStatusArray>("move_base/status", 10, true);
  const ros::Publisher feedback =
      node_.advertise<move_base_msgs::MoveBaseActionFeedback>("move_base/feedback", 1);
  const ros::Publisher result =
      node_.advertise<move_base_msgs::MoveBaseActionResult>("move_base/result", 1);
  const ros::Subscriber goals = node_.subscribe<move_base_msgs::MoveBaseActionGoal>(
      "move_base/goal", 10, [&](const move_base_msgs::MoveBaseActionGoalConstPtr& message) {
        goal = message->goal_id;
        has_goal = true;
      });
  const ros::Subscriber cancels = node_.subscribe<actionlib_msgs::GoalID>(
      "move_base/cancel", 10, [&](const actionlib_msgs::GoalIDConstPtr& id) {
        if (id->id.empty()) has_heard_cancel = true;
        if (has_goal && id->id == goal.id) is_cancelled = true;
      });
  status.publish(actionlib_msgs::GoalStatusArray());
  harness_.Tick();
  ASSERT_TRUE(Eventually([&] { return has_goal.load(); }));
  harness_.Halt();
  ASSERT_TRUE(Eventually([&] { return has_heard_cancel.load(); }));
  actionlib_msgs::GoalStatusArray taken;
  taken.status_list.resize(1);
  taken.status_list[0].goal_id = goal;
  taken.status_list[0].status = actionlib_msgs::GoalStatus::ACTIVE;
  status.publish(taken);
  EXPECT_TRUE(Eventually([&] { return is_cancelled.load(); }));
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
  EXPECT_EQ(harness_.message(), R"(action server "move_base" is gone)");
}

TEST_F(RosNavigatorTest, SaysThatThereIsNoServer) {
  EXPECT_TRUE(EndsWith(Status::kFailure, 20));
  EXPECT_EQ(harness_.message(), R"(no action server "move_base")");
}

// The action server "docking", which notes what it is to do.
class DockingServer {
 public:
  explicit DockingServer(ros::NodeHandle& node) : server_(node, "docking", false) {
    server_.registerGoalCallback([this] {
      lateral_offset = server_.acceptNewGoal()->lateral_offset;
      has_goal = true;
    });
    server_.start();
  }
  void Succeed() {
    coppice_msgs::DockingResult result;
    result.ok = true;
    server_.setSucceeded(result);
  }

  std::atomic<bool> has_goal{false};
  std::atomic<double> lateral_offset{0};

 private:
  actionlib::SimpleActionServer<coppice_msgs::DockingAction> server_;
};

class RosChargingStationTest : public testing::Test {
 protected:
  bool EndsWith(Status status) {
    return Eventually([&] { return harness_.Tick() == status; }, 20);
  }
  // The leaf waits for a server that has the goal.
  std::unique_ptr<DockingServer> StartServer() {
    auto server = std::make_unique<DockingServer>(node_);
    harness_.Tick();
    EXPECT_TRUE(Eventually([&] { return server->has_goal.load(); }));
    return server;
  }

  ros::NodeHandle node_;
  std::unique_ptr<leaves::ChargingStation> station_ = MakeRosChargingStation(node_);
  LeafHarness harness_ = LeafHarness::For<leaves::Dock>(std::ref(*station_));
};

TEST_F(RosChargingStationTest, WhoIsStartedAfterADockingThatDiedDocksAsWell) {
  harness_.Set("lateral_offset", 0.04);
  StartServer().reset();
  const auto successor = StartServer();
  EXPECT_EQ(successor->lateral_offset, 0.04);
  EXPECT_EQ(harness_.Tick(), Status::kRunning) << harness_.message();
  successor->Succeed();
  EXPECT_TRUE(EndsWith(Status::kSuccess)) << harness_.message();
}

// Its first status does not know the goal: long after that was sent, no status has overtaken it.
TEST_F(RosChargingStationTest, WhoIsThereBeforeTheDeathIsNoticedDocksAsWell) {
  auto server = StartServer();
  const ros::WallTime long_after = ros::WallTime::now() + ros::WallDuration(1.2);
  ASSERT_TRUE(Eventually([&] { return ros::WallTime::now() > long_after; }));
  server.reset();
  server = StartServer();
  EXPECT_EQ(harness_.Tick(), Status::kRunning) << harness_.message();
  server->Succeed();
  EXPECT_TRUE(EndsWith(Status::kSuccess)) << harness_.message();
}

TEST_F(RosChargingStationTest, ADockingThatDiesTwiceHasFailed) {
  StartServer().reset();
  StartServer().reset();
  EXPECT_TRUE(EndsWith(Status::kFailure));
  EXPECT_EQ(harness_.message(), R"(action server "docking" is gone)");
}

}  // namespace
}  // namespace coppice::robot::adapters
