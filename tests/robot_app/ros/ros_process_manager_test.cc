#include "robot_app/ros/ros_process_manager.h"

#include <coppice_msgs/RestartProcess.h>
#include <coppice_msgs/SetConfiguration.h>
#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"
#include "bt_nodes/processes/process_leaves.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot::adapters {
namespace {

using leaves::ProcessManager;
using leaves::RestartNode;
using Restart = coppice_msgs::RestartProcess;
using Configure = coppice_msgs::SetConfiguration;

TEST(RosProcessManager, RestartsANodeThroughTheSupervisor) {
  ros::NodeHandle node;
  const boost::function<bool(Restart::Request&, Restart::Response&)> answer =
      [](Restart::Request& request, Restart::Response& response) {
        response.ok = request.name == "/navigation";
        return true;
      };
  const ros::ServiceServer server = node.advertiseService("/supervisor/restart", answer);
  RosProcessManager manager;
  LeafHarness harness = LeafHarness::For<RestartNode>(std::ref<ProcessManager>(manager));
  harness.Set("node", std::string("/navigation"));
  EXPECT_TRUE(Eventually([&] { return harness.Tick() == Status::kSuccess; }));
}

TEST(RosProcessManager, ReportsARefusedRestart) {
  ros::NodeHandle node;
  const boost::function<bool(Restart::Request&, Restart::Response&)> answer =
      [](Restart::Request&, Restart::Response& response) {
        response.ok = false;
        response.message = "restarted too often";
        return true;
      };
  const ros::ServiceServer server = node.advertiseService("/supervisor/restart", answer);
  RosProcessManager manager;
  LeafHarness harness = LeafHarness::For<RestartNode>(std::ref<ProcessManager>(manager));
  harness.Set("node", std::string("/navigation"));
  EXPECT_TRUE(Eventually([&] { return harness.Tick() == Status::kFailure; }));
  EXPECT_EQ(harness.message(), "restarted too often");
}

TEST(RosProcessManager, FailsWhenTheSupervisorIsNotThere) {
  RosProcessManager manager;
  LeafHarness harness = LeafHarness::For<RestartNode>(std::ref<ProcessManager>(manager));
  harness.Set("node", std::string("/navigation"));
  EXPECT_TRUE(Eventually([&] { return harness.Tick() == Status::kFailure; }));
  EXPECT_EQ(harness.message(), "service /supervisor/restart does not answer");
}

TEST(RosProcessManager, AsksForAConfiguration) {
  ros::NodeHandle node;
  std::mutex mutex;
  std::string asked_for;
  const boost::function<bool(Configure::Request&, Configure::Response&)> answer =
      [&](Configure::Request& request, Configure::Response& response) {
        const std::lock_guard<std::mutex> lock(mutex);
        asked_for = request.configuration;
        response.ok = true;
        return true;
      };
  const ros::ServiceServer server = node.advertiseService("/supervisor/set_configuration", answer);
  RosProcessManager manager;
  manager.SetConfiguration("charging");
  EXPECT_TRUE(Eventually([&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return asked_for == "charging";
  }));
}

}  // namespace
}  // namespace coppice::robot::adapters
