#include "robot_app/app/robot_watch.h"

#include <coppice_msgs/Health.h>
#include <coppice_msgs/ProcessStates.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <std_msgs/String.h>

#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot {
namespace {

class RobotWatchTest : public testing::Test {
 protected:
  template <class Message>
  ros::Publisher Publish(const std::string& topic, const Message& message) {
    ros::Publisher publisher = node_.advertise<Message>(topic, 10, true);
    publisher.publish(message);
    return publisher;
  }
  ros::NodeHandle node_;
  RobotWatch watch_{node_};
};

TEST_F(RobotWatchTest, SeesTheApplicationEnd) {
  std_msgs::String status;
  status.data = "SUCCESS";
  const auto publisher = Publish("/coppice/application", status);
  EXPECT_TRUE(watch_.WaitFor([](const RobotView& v) { return v.application == "SUCCESS"; }, 10));
}

TEST_F(RobotWatchTest, KnowsTheNumbersOfRunningProcesses) {
  coppice_msgs::ProcessStates states;
  states.configuration = "operating";
  states.processes.resize(2);
  states.processes[0].name = "navigation";
  states.processes[0].pid = 42;
  states.processes[0].state = coppice_msgs::ProcessState::READY;
  states.processes[1].name = "docking";
  const auto publisher = Publish("/processes", states);
  ASSERT_TRUE(watch_.WaitFor([](const RobotView& v) { return v.pids.size() == 1; }, 10));
  EXPECT_EQ(watch_.view().pids.at("navigation"), 42);
  EXPECT_TRUE(watch_.view().ready.at("navigation"));
  EXPECT_FALSE(watch_.view().ready.at("docking"));
}

TEST_F(RobotWatchTest, SeesWhichProcessWasGivenUp) {
  coppice_msgs::ProcessStates states;
  states.processes.resize(1);
  states.processes[0].name = "docking";
  states.processes[0].state = coppice_msgs::ProcessState::GIVEN_UP;
  const auto publisher = Publish("/processes", states);
  EXPECT_TRUE(watch_.WaitFor(
      [](const RobotView& v) { return v.given_up == std::vector<std::string>{"docking"}; }, 10));
}

TEST_F(RobotWatchTest, KeepsErrorsAndStaleEntriesOnly) {
  coppice_msgs::Health health;
  health.entries.resize(3);
  health.entries[0].level = coppice_msgs::HealthEntry::WARN;
  health.entries[1].level = coppice_msgs::HealthEntry::ERROR;
  health.entries[1].monitor = "node";
  health.entries[1].subject = "/a";
  health.entries[1].message = "does not answer";
  health.entries[2].level = coppice_msgs::HealthEntry::STALE;
  const auto publisher = Publish("/monitoring", health);
  ASSERT_TRUE(watch_.WaitFor([](const RobotView& v) { return !v.errors.empty(); }, 10));
  EXPECT_EQ(watch_.view().errors.size(), 2u);
  EXPECT_EQ(watch_.view().errors[0], "node /a: does not answer");
}

TEST_F(RobotWatchTest, AddsUpTheDistanceDriven) {
  ros::Publisher publisher = node_.advertise<nav_msgs::Odometry>("/odom", 10);
  ASSERT_TRUE(Eventually([&] { return publisher.getNumSubscribers() > 0; }));
  for (const double x : {0.0, 3.0, 1.0}) {
    nav_msgs::Odometry odometry;
    odometry.pose.pose.position.x = x;
    publisher.publish(odometry);
  }
  EXPECT_TRUE(watch_.WaitFor([](const RobotView& v) { return v.distance == 5.0; }, 10));
}

TEST_F(RobotWatchTest, GivesUpAtTheDeadline) {
  EXPECT_FALSE(watch_.WaitFor([](const RobotView&) { return false; }, 0.05));
}

}  // namespace
}  // namespace coppice::robot
