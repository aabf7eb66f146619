#include "robot_app/simulation/node_signals.h"

#include <gmock/gmock.h>
#include <ros/master.h>
#include <signal.h>

#include <fstream>

#include "robot_app/common/child_process.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/support/folders.h"

namespace coppice::robot::simulation {
namespace {

using testing::HasSubstr;

const std::string kProgram = BinaryFolder() + "/bin/coppice-simulator";

// The third field of /proc/PID/stat: R running, S sleeping, T stopped ...
char StateOf(pid_t pid) {
  std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
  std::string number;
  std::string name;
  char state = '?';
  stat >> number >> name >> state;
  return state;
}

NodeSignals MakeSignals() {
  return NodeSignals(ros::master::getURI(), ros::this_node::getName(), "127.0.0.1");
}

bool Knows(const std::string& node) {
  ros::V_string nodes;
  return ros::master::getNodes(nodes) && std::find(nodes.begin(), nodes.end(), node) != nodes.end();
}

TEST(NodeSignals, StopResumeAndKillTheProcessOfANode) {
  ChildProcess victim({kProgram, "__name:=victim"}, testing::TempDir() + "victim.log");
  ASSERT_TRUE(Eventually([] { return Knows("/victim"); }));
  NodeSignals signals = MakeSignals();
  const Change stopped = signals.Send("/victim", SIGSTOP);
  EXPECT_TRUE(stopped) << stopped.problem();
  EXPECT_TRUE(Eventually([&] { return StateOf(victim.pid()) == 'T'; }));
  EXPECT_TRUE(signals.Send("victim", SIGCONT));
  EXPECT_TRUE(Eventually([&] { return StateOf(victim.pid()) != 'T'; }));
  const Change killed = signals.Send("/victim", SIGKILL);
  EXPECT_TRUE(killed) << killed.problem();
  EXPECT_TRUE(Eventually([&] { return !victim.IsRunning(); }));
  EXPECT_EQ(victim.exit_status(), 128 + SIGKILL);
  EXPECT_THAT(signals.Send("/victim", SIGKILL).problem(), HasSubstr("does not answer"));
}

TEST(NodeSignals, RefuseThemselvesAndTheUnknown) {
  NodeSignals signals = MakeSignals();
  EXPECT_FALSE(signals.Send(ros::this_node::getName(), SIGKILL));
  const Change unknown = signals.Send("/coppice_tost", SIGKILL);
  EXPECT_FALSE(unknown);
  EXPECT_THAT(unknown.problem(), HasSubstr("the master knows no node"));
}

TEST(NodeSignals, RefuseNodesOfAnotherMachine) {
  XmlRpc::XmlRpcValue request;
  request[0] = "/far_away";
  request[1] = "/topic";
  request[2] = "std_msgs/String";
  request[3] = "http://192.0.2.1:4/";
  XmlRpc::XmlRpcValue answer;
  XmlRpc::XmlRpcValue payload;
  ASSERT_TRUE(ros::master::execute("registerSubscriber", request, answer, payload, false));
  EXPECT_THAT(MakeSignals().Send("/far_away", SIGKILL).problem(),
              HasSubstr("/far_away runs on another machine"));
}

TEST(NodeSignals, FailWithoutAMaster) {
  NodeSignals signals("http://127.0.0.1:1", "/somebody", "127.0.0.1");
  EXPECT_FALSE(signals.Send("/coppice_test", SIGKILL));
}

}  // namespace
}  // namespace coppice::robot::simulation
