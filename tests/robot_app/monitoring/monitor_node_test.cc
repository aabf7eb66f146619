// The monitors' programs and the aggregator, with a real master and real nodes: from a broken node
// to the error on /monitoring.
#include "robot_app/monitoring/monitor_node.h"

#include <coppice_msgs/NavigationState.h>
#include <coppice_msgs/ProcessStates.h>
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "tests/robot_app/monitoring/monitor_graph.h"

namespace coppice::robot::monitoring {
namespace {

using testing::HasSubstr;

constexpr char kConfig[] = R"(
configurations:
  operating:
    nodes: [{node: /victim}]
    topics:
      - {topic: /steady, node: /steady_talker, warn: [15, 25], error: [10, 30], staleness: 1}
      - {topic: /slow, node: /slow_talker, error: [10, 30], staleness: 5}
      - {topic: /fast, node: /fast_talker, error: [10, 30], staleness: 1}
      - {topic: /silent, node: /silent_talker, staleness: 1}
    navigation: {topic: /navigation/state, node: /navigation, staleness: 2}
  charging:
    nodes: [{node: /absent}]
)";

class MonitorNodeTest : public MonitorGraphTest {
 protected:
  MonitorNodeTest() : MonitorGraphTest(kConfig) {}
};

TEST_F(MonitorNodeTest, AKilledOrHungNodeIsAnError) {
  StartMonitor("node-monitor");
  const auto start = [this] {
    return graph_.Start("victim", {processes::kTestPrograms + "test_talker", "__name:=victim"});
  };
  int victim = start();
  ASSERT_TRUE(WaitForLevel("node", "/victim", HealthEntry::OK));

  graph_.Kill(victim, SIGKILL);
  ASSERT_TRUE(WaitForLevel("node", "/victim", HealthEntry::ERROR));
  EXPECT_EQ(Find("node", "/victim")->node, "/victim");
  EXPECT_THAT(Find("node", "/victim")->message, HasSubstr("refuses connections"));

  victim = start();
  ASSERT_TRUE(WaitForLevel("node", "/victim", HealthEntry::OK));
  graph_.Hang(victim);
  ASSERT_TRUE(WaitForLevel("node", "/victim", HealthEntry::ERROR));
  EXPECT_THAT(Find("node", "/victim")->message, HasSubstr("does not answer"));
  kill(victim, SIGCONT);
  EXPECT_TRUE(WaitForLevel("node", "/victim", HealthEntry::OK));
}

TEST_F(MonitorNodeTest, TopicsThatAreTooSlowTooFastOrSilentAreErrors) {
  StartTalker("steady", 20);
  StartTalker("slow", 5);
  StartTalker("fast", 60);
  StartMonitor("topic-monitor");
  ASSERT_TRUE(WaitForLevel("topic", "/silent", HealthEntry::ERROR));
  ASSERT_TRUE(WaitForLevel("topic", "/slow", HealthEntry::ERROR));
  ASSERT_TRUE(WaitForLevel("topic", "/fast", HealthEntry::ERROR));
  EXPECT_EQ(Find("topic", "/slow")->node, "/slow_talker");
  EXPECT_NEAR(Find("topic", "/slow")->value, 5, 1.5);
  EXPECT_GT(Find("topic", "/fast")->value, 30);
  EXPECT_THAT(Find("topic", "/silent")->message, HasSubstr("no message for"));
  EXPECT_TRUE(WaitForLevel("topic", "/steady", HealthEntry::OK));
}

TEST_F(MonitorNodeTest, ABlockedPathIsAnErrorOfTheNavigation) {
  ros::Publisher states =
      graph_.node().advertise<coppice_msgs::NavigationState>("/navigation/state", 5);
  StartMonitor("navigation-monitor");
  coppice_msgs::NavigationState state;
  const auto tell = [&](double seconds) {
    const int level = state.state == state.NO_PATH ? HealthEntry::ERROR : HealthEntry::OK;
    return graph_.WaitFor(
        [&] {
          states.publish(state);
          const HealthEntry* entry = Find("navigation", "progress");
          return entry && entry->level == level && entry->message != "state unknown";
        },
        seconds);
  };
  EXPECT_TRUE(tell(10));  // idle
  state.state = state.NO_PATH;
  state.consecutive_failures = 1;
  EXPECT_TRUE(tell(3));
  EXPECT_TRUE(WaitForLevel("topic", "/navigation/state", HealthEntry::ERROR));  // now silent
  EXPECT_EQ(Find("topic", "/navigation/state")->node, "/navigation");
}

TEST_F(MonitorNodeTest, TheSupervisorsWordCountsWhileItStartsANodeAndChangesTheConfiguration) {
  ros::Publisher processes =
      graph_.node().advertise<coppice_msgs::ProcessStates>("/processes", 5, true);
  coppice_msgs::ProcessStates message;
  message.configuration = "charging";
  message.processes.resize(1);
  message.processes[0].node = "/absent";
  message.processes[0].state = coppice_msgs::ProcessState::STARTING;
  processes.publish(message);
  StartMonitor("node-monitor");
  ASSERT_TRUE(graph_.WaitFor([&] {
    const HealthEntry* entry = Find("node", "/absent");
    return entry && entry->level == HealthEntry::OK && entry->message == "starting";
  }));
  EXPECT_TRUE(graph_.WaitFor([&] { return !Find("node", "/victim"); }));
  message.processes[0].state = coppice_msgs::ProcessState::STOPPED;
  message.processes[0].message = "ended by signal 9";
  processes.publish(message);
  ASSERT_TRUE(WaitForLevel("node", "/absent", HealthEntry::ERROR));
  EXPECT_THAT(Find("node", "/absent")->message, HasSubstr("process ended by signal 9"));
  message.configuration = "operating";
  processes.publish(message);
  EXPECT_TRUE(graph_.WaitFor([&] { return Find("node", "/victim"); }));
}

TEST_F(MonitorNodeTest, TheAggregateIsPublishedFourTimesPerSecondEvenWithoutReports) {
  ASSERT_TRUE(graph_.WaitFor([&] { return publications_ > 0; }));
  const int before = publications_;
  const ros::Time begin = health_.header.stamp;
  ASSERT_TRUE(graph_.WaitFor([&] { return publications_ >= before + 8; }));
  EXPECT_GT((health_.header.stamp - begin).toSec(), 1.2) << "two seconds, if none comes late";
}

TEST_F(MonitorNodeTest, BadInputEndsAProgramWithOneLineAndStatus2) {
  const auto run = [this](std::vector<std::string> arguments, const std::string& name) {
    arguments.insert(arguments.begin(), processes::kPrograms + "coppice-node-monitor");
    std::remove((processes::Temporary("ros_graph/") + name + ".log").c_str());
    int status = 0;
    waitpid(graph_.Start(name, std::move(arguments)), &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 2);
    std::ostringstream text;
    text << std::ifstream(processes::Temporary("ros_graph/") + name + ".log").rdbuf();
    return text.str();
  };
  EXPECT_THAT(run({}, "usage"), HasSubstr("--config is required"));
  EXPECT_EQ(run({"--config", "/nowhere"}, "missing"),
            "/nowhere: error: cannot be read: No such file or directory\n");
  const std::string port = std::to_string(processes::FreePort());
  EXPECT_EQ(run({"--config", config_, "__master:=http://127.0.0.1:" + port}, "no_master"),
            "node_monitor: no ROS master at http://127.0.0.1:" + port + " (ROS_MASTER_URI)\n");
}

}  // namespace
}  // namespace coppice::robot::monitoring
