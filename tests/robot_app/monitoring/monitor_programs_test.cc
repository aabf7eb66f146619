// The programs that carry several monitors, with a real master: from the topic, or the computer, to
// the entry on /monitoring and to /diagnostics.
#include <actionlib_msgs/GoalStatusArray.h>
#include <coppice_msgs/DockingActionFeedback.h>
#include <coppice_msgs/LocalizationState.h>
#include <coppice_msgs/ProcessStates.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gmock/gmock.h>
#include <sensor_msgs/BatteryState.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>

#include "tests/robot_app/monitoring/monitor_graph.h"

namespace coppice::robot::monitoring {
namespace {

using processes::kPrograms;
using testing::HasSubstr;

constexpr char kConfig[] = R"(
report_period: 0.2
patience: 0
system:
  - host: tester
    period: 0.2
    ask_period: 0.2
    window: 1
    memory: {used: {warn: [none, 2], error: [none, 2]}}
    disks: [{path: /}, {path: /nowhere}]
    network: [{interface: lo}]
    clocks: [{host: wrong, address: 127.0.0.1, port: $PORT}]
    hosts: [{host: here, address: 127.0.0.1, port: 1}]
    processes: [{node: /big_talker}]
  - host: another
configurations:
  operating:
    topics:
      - {topic: /big, node: /big_talker, by: statistics, error: [5, 50], staleness: 10}
    publishers: [{topic: /cmd_vel, nodes: [/velocity_mux]}]
    localization: {topic: /localization/state, node: /localization, staleness: 2}
    transforms: [{parent: map, child: base, age: {error: [none, 1], staleness: 1}}]
    loggers: [{name: record, path: run.log, staleness: 1},
              {name: bag, topic: /recorder/status, staleness: 1}]
    diagnostics: {staleness: 2}
    battery: {topic: /battery_state, node: /base, staleness: 2,
              voltage: {error: [23, none]}, dock: {x: 0, y: 0, base_frame: base}}
    charging: {within: 1, interruption: 1}
    docking: {action: /docking, node: /docking, staleness: 2, failures: {error: [none, 1]}}
    emergency_stop: {topic: /stop}
    sources: [{source: /system_monitor, period: 0.2}]
)";

std::string WithPort(int port) {
  std::string text = kConfig;
  text.replace(text.find("$PORT"), 5, std::to_string(port));
  return text;
}

class MonitorProgramsTest : public MonitorGraphTest {
 protected:
  MonitorProgramsTest() : MonitorGraphTest(WithPort(kPort)) {}

  template <class Message>
  ros::Publisher Advertise(const std::string& topic) {
    return graph_.node().advertise<Message>(topic, 10, true);
  }
  // Publishes again and again until the entry is as the predicate wants it.
  template <class Message, class Predicate>
  bool TellUntil(const ros::Publisher& publisher, const Message& message,
                 const std::string& monitor, const std::string& subject, Predicate is_right) {
    return graph_.WaitFor([&] {
      publisher.publish(message);
      const HealthEntry* entry = Find(monitor, subject);
      return entry && is_right(*entry);
    });
  }
  template <class Message>
  bool Tell(const ros::Publisher& publisher, const Message& message, const std::string& monitor,
            const std::string& subject, int level) {
    return TellUntil(publisher, message, monitor, subject,
                     [level](const HealthEntry& entry) { return entry.level == level; });
  }

  static const int kPort;
};

const int MonitorProgramsTest::kPort = processes::FreePort();

TEST_F(MonitorProgramsTest, AComputerIsMeasuredAndAClockThatIsThreeSecondsOffIsAnError) {
  graph_.Start("time", {kPrograms + "coppice-system-monitor", "--serve-time", std::to_string(kPort),
                        "--clock-offset", "3"});
  StartTalker("big", 20);
  graph_.Start("system",
               {kPrograms + "coppice-system-monitor", "--config", config_, "--host", "tester"});
  ASSERT_TRUE(WaitForLevel("clock", "wrong", HealthEntry::ERROR));
  EXPECT_NEAR(Find("clock", "wrong")->value, 3, 0.5);
  EXPECT_EQ(Find("clock", "wrong")->host, "tester");
  EXPECT_TRUE(WaitForLevel("disk", "/nowhere", HealthEntry::ERROR));
  EXPECT_TRUE(WaitForLevel("network", "host here", HealthEntry::OK));
  EXPECT_TRUE(WaitForLevel("network", "lo load", HealthEntry::OK));
  EXPECT_GT(Find("memory", "used")->value, 0);
  EXPECT_TRUE(graph_.WaitFor([this] { return Find("process", "/big_talker memory")->value > 1; }));
  EXPECT_TRUE(graph_.WaitFor([this] { return !std::isnan(Find("cpu", "load")->value); }));
}

TEST_F(MonitorProgramsTest, AComputerIsMeasuredInAConfigurationThatNobodyKnows) {
  graph_.Start("system",
               {kPrograms + "coppice-system-monitor", "--config", config_, "--host", "tester"});
  ASSERT_TRUE(WaitForLevel("memory", "used", HealthEntry::OK));
  const ros::Publisher publisher = Advertise<coppice_msgs::ProcessStates>("/processes");
  coppice_msgs::ProcessStates states;
  states.configuration = "unheard-of";
  publisher.publish(states);
  ASSERT_TRUE(WaitForLevel("aggregation", "/system_monitor", HealthEntry::WARN));
  const ros::Time then = ros::Time::now();
  EXPECT_TRUE(graph_.WaitFor([&] {
    const HealthEntry* entry = Find("memory", "used");
    return entry && entry->stamp > then && entry->level == HealthEntry::OK;
  }));
}

TEST_F(MonitorProgramsTest, AStrangerOnTheTopicOfTheDriveIsAnError) {
  StartMonitor("topic-monitor");
  ASSERT_TRUE(WaitForLevel("publisher", "/cmd_vel", HealthEntry::OK));
  EXPECT_TRUE(Tell(Advertise<std_msgs::Bool>("/cmd_vel"), std_msgs::Bool(), "publisher", "/cmd_vel",
                   HealthEntry::ERROR));
  EXPECT_THAT(Find("publisher", "/cmd_vel")->message,
              HasSubstr(ros::this_node::getName() + " publishes here"));
}

TEST_F(MonitorProgramsTest, ASilentMonitorIsAnErrorAndAStrangerIsNamed) {
  const int pid = graph_.Start(
      "system", {kPrograms + "coppice-system-monitor", "--config", config_, "--host", "tester"});
  ASSERT_TRUE(WaitForLevel("memory", "used", HealthEntry::OK));
  EXPECT_EQ(Find("aggregation", "/system_monitor"), nullptr);
  graph_.Kill(pid, SIGKILL);
  ASSERT_TRUE(WaitForLevel("memory", "used", HealthEntry::STALE));
  EXPECT_EQ(Find("memory", "used")->node, "/system_monitor");
  StartMonitor("topic-monitor");
  ASSERT_TRUE(WaitForLevel("aggregation", "/topic_monitor", HealthEntry::WARN));
  EXPECT_THAT(Find("aggregation", "/topic_monitor")->message, HasSubstr("unknown source"));
}

TEST_F(MonitorProgramsTest, TheBatteryIsJudgedAndItsSilenceIsAnError) {
  using State = sensor_msgs::BatteryState;
  const auto batteries = Advertise<State>("/battery_state");
  StartMonitor("power-monitor");
  State state;
  state.voltage = 24;
  state.percentage = 0.8f;
  state.charge = 60;
  state.current = -6;
  ASSERT_TRUE(Tell(batteries, state, "battery", "voltage", HealthEntry::OK));
  EXPECT_TRUE(Tell(batteries, state, "battery", "state", HealthEntry::OK));
  EXPECT_TRUE(TellUntil(batteries, state, "battery", "margin",
                        [](const HealthEntry& entry) { return entry.value > 0; }));
  EXPECT_TRUE(Tell(batteries, state, "charging", "current", HealthEntry::OK));
  state.voltage = 22;
  EXPECT_TRUE(Tell(batteries, state, "battery", "voltage", HealthEntry::ERROR));
  state.power_supply_status = State::POWER_SUPPLY_STATUS_NOT_CHARGING;
  EXPECT_TRUE(TellUntil(batteries, state, "charging", "current", [](const HealthEntry& entry) {
    return entry.level == HealthEntry::ERROR &&
           entry.message.find("contact without current") != std::string::npos;
  }));
  ASSERT_TRUE(WaitForLevel("battery", "state", HealthEntry::ERROR));  // now silent
  EXPECT_EQ(Find("battery", "state")->node, "/base");
}

TEST_F(MonitorProgramsTest, DockingThatFailsAgainAndTheEmergencyStopAreErrors) {
  const auto docking = Advertise<actionlib_msgs::GoalStatusArray>("/docking/status");
  const auto progress = Advertise<coppice_msgs::DockingActionFeedback>("/docking/feedback");
  const auto stop = Advertise<std_msgs::Bool>("/stop");
  StartMonitor("power-monitor");
  const actionlib_msgs::GoalStatusArray goals;
  ASSERT_TRUE(Tell(docking, goals, "docking", "failures", HealthEntry::OK));
  std_msgs::Bool pressed;
  pressed.data = 1;
  EXPECT_TRUE(Tell(stop, pressed, "emergency_stop", "button", HealthEntry::ERROR));
  pressed.data = 0;
  EXPECT_TRUE(Tell(stop, pressed, "emergency_stop", "button", HealthEntry::OK));
  // By now no list without a goal is under way any more that could come behind the feedback.
  coppice_msgs::DockingActionFeedback attempt;
  attempt.status.goal_id.id = "to the station";
  attempt.feedback.failed_attempts = 2;
  attempt.feedback.why_failed = "no current";
  ASSERT_TRUE(Tell(progress, attempt, "docking", "failures", HealthEntry::ERROR));
  EXPECT_EQ(Find("docking", "failures")->message, "2 in a row: no current");
}

TEST_F(MonitorProgramsTest, ALostRobotAndASilentLocalizationAreErrors) {
  using State = coppice_msgs::LocalizationState;
  const auto states = Advertise<State>("/localization/state");
  StartMonitor("navigation-monitor");
  State state;
  state.score = 1;
  ASSERT_TRUE(Tell(states, state, "localization", "phase", HealthEntry::OK));
  state.phase = State::LOST;
  state.message = "no match";
  ASSERT_TRUE(Tell(states, state, "localization", "phase", HealthEntry::ERROR));
  EXPECT_EQ(Find("localization", "phase")->message, "lost: no match");
  EXPECT_EQ(Find("localization", "phase")->node, "/localization");
  EXPECT_TRUE(WaitForLevel("topic", "/localization/state", HealthEntry::ERROR));
}

TEST_F(MonitorProgramsTest, AMissingTransformAndAChildWithAnotherParentAreErrors) {
  StartMonitor("navigation-monitor");
  ASSERT_TRUE(WaitForLevel("tf", "map -> base age", HealthEntry::ERROR));
  const auto tf = Advertise<tf2_msgs::TFMessage>("/tf");
  const auto publish = [&tf](const std::vector<std::pair<std::string, std::string>>& pairs) {
    tf2_msgs::TFMessage message;
    for (const auto& [parent, child] : pairs) {
      geometry_msgs::TransformStamped transform;
      transform.header.stamp = ros::Time::now();
      transform.header.frame_id = parent;
      transform.child_frame_id = child;
      transform.transform.rotation.w = 1;
      message.transforms.push_back(transform);
    }
    tf.publish(message);
  };
  const auto wait_for = [&](const char* what, int level, const auto& pairs) {
    return graph_.WaitFor([&] {
      publish(pairs);
      const HealthEntry* entry = Find("tf", std::string("map -> base ") + what);
      return entry && entry->level == level;
    });
  };
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  const Pairs before = {{"map", "odom"}, {"odom", "base"}};
  EXPECT_TRUE(wait_for("age", HealthEntry::OK, before));
  EXPECT_TRUE(wait_for("parent", HealthEntry::OK, before));
  EXPECT_TRUE(wait_for("parent", HealthEntry::ERROR, Pairs{{"map", "wheels"}, {"wheels", "base"}}));
}

TEST_F(MonitorProgramsTest, ALoggerThatIsDownIsAnErrorUntilItWrites) {
  const std::string folder = processes::Temporary("logs");
  std::filesystem::create_directories(folder);
  graph_.Start("topic",
               {kPrograms + "coppice-topic-monitor", "--config", config_, "--folder", folder});
  ASSERT_TRUE(WaitForLevel("logger", "record", HealthEntry::ERROR));
  ASSERT_TRUE(WaitForLevel("logger", "bag", HealthEntry::ERROR));
  EXPECT_TRUE(graph_.WaitFor([&] {
    std::ofstream(folder + "/run.log", std::ios::app) << "line\n";
    return Find("logger", "record")->level == HealthEntry::OK;
  }));
  const auto recorder = Advertise<std_msgs::String>("/recorder/status");
  EXPECT_TRUE(Tell(recorder, std_msgs::String(), "logger", "bag", HealthEntry::OK));
}

TEST_F(MonitorProgramsTest, ABigTopicIsJudgedByTheStatisticsOfItsSubscribers) {
  graph_.node().setParam("/enable_statistics", true);
  int received = 0;
  const ros::Subscriber viewer = graph_.node().subscribe<std_msgs::String>(
      "/big", 10, [&received](const std_msgs::String::ConstPtr&) { ++received; });
  // roscpp does not hear of a publisher that comes at the very moment in which it subscribes.
  StartMonitor("topic-monitor");
  ASSERT_TRUE(graph_.WaitFor([this] { return Find("topic", "/big") != nullptr; }));
  StartTalker("big", 20);
  ASSERT_TRUE(graph_.WaitFor([this] {
    const HealthEntry* entry = Find("topic", "/big");
    return entry && entry->value > 10 && entry->value < 30;
  })) << received
      << " messages came, " << (Find("topic", "/big") ? Find("topic", "/big")->value : -1)
      << " a second were told";
  EXPECT_EQ(Find("topic", "/big")->level, HealthEntry::OK);
  graph_.node().deleteParam("/enable_statistics");
}

TEST_F(MonitorProgramsTest, DiagnosticsOfOthersComeInAndOursGoOutButNotInCircles) {
  using Status = diagnostic_msgs::DiagnosticStatus;
  std::vector<std::string> ours;
  const ros::Subscriber reader = graph_.node().subscribe<diagnostic_msgs::DiagnosticArray>(
      "/diagnostics", 10, [&ours](const diagnostic_msgs::DiagnosticArray::ConstPtr& message) {
        for (const Status& status : message->status) {
          if (status.name != "lidar: motor") ours.push_back(status.name);
          EXPECT_TRUE(status.name == "lidar: motor" || !status.hardware_id.empty());
        }
      });
  const auto lidar = Advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics");
  StartMonitor("topic-monitor");
  diagnostic_msgs::DiagnosticArray array;
  array.status.resize(1);
  array.status[0].name = "lidar: motor";
  array.status[0].level = Status::ERROR;
  array.status[0].message = "stuck";
  ASSERT_TRUE(Tell(lidar, array, "diagnostics", "lidar: motor", HealthEntry::ERROR));
  EXPECT_EQ(Find("diagnostics", "lidar: motor")->message, "stuck");
  ASSERT_TRUE(WaitForLevel("diagnostics", "lidar: motor", HealthEntry::STALE));
  ASSERT_TRUE(graph_.WaitFor([&ours] { return ours.size() > 20; }));
  EXPECT_THAT(ours, testing::Contains("coppice: logger record"));
  for (const std::string& name : ours) EXPECT_THAT(name, testing::StartsWith("coppice: "));
  for (const HealthEntry& entry : health_.entries) {
    if (entry.monitor == "diagnostics") {
      EXPECT_EQ(entry.subject, "lidar: motor");
    }
  }
}

}  // namespace
}  // namespace coppice::robot::monitoring
