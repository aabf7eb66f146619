#include "robot_app/monitoring/monitor_config.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "robot_app/processes/config/robot_config.h"
#include "tests/robot_app/processes/temporary.h"
#include "tests/support/folders.h"

namespace coppice::robot::monitoring {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::HasSubstr;

class MonitorConfigTest : public testing::Test {
 protected:
  MonitorConfig Read(const std::string& text) {
    const std::string path = processes::Temporary("monitor_config_test.yaml");
    std::ofstream(path) << text;
    return LoadMonitorConfig(path, diagnostics_);
  }
  std::string Errors() const { return diagnostics_.ToString(); }
  Diagnostics diagnostics_;
};

TEST_F(MonitorConfigTest, ReadsWhatIsWatchedInEachConfiguration) {
  const MonitorConfig config = Read(R"(
report_period: 0.2
patience: 0.6
node_monitor: {deadline: 0.3, misses: 3}
topic_monitor: {window: 4}
health_aggregator: {period: 0.1, hold: 0.7, silent_periods: 5}
initial: operating
configurations:
  charging: {}
  operating:
    nodes: [{node: /a}, {node: /b, misses: 1}]
    topics:
      - {topic: /scan, node: /a, warn: [8, 12], error: [5, none], staleness: 1.5}
      - {topic: /clock, node: /a, time: wall, window: 1}
    navigation: {topic: /navigation/state, node: /b, blocked: 7, no_path: 3, staleness: 2}
    sources: [{source: /node_monitor, period: 0.5}]
)");
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(config.report_period, milliseconds(200));
  EXPECT_EQ(config.patience, milliseconds(600));
  EXPECT_EQ(config.ping_deadline, milliseconds(300));
  EXPECT_EQ(config.publish_period, milliseconds(100));
  EXPECT_EQ(config.hold, milliseconds(700));
  EXPECT_EQ(config.silent_periods, 5);
  EXPECT_EQ(config.initial, "operating");
  const WatchList& list = config.ForConfiguration("operating");
  ASSERT_EQ(list.nodes.size(), 2u);
  EXPECT_EQ(list.nodes[0].misses, 3);
  EXPECT_EQ(list.nodes[1].misses, 1);
  ASSERT_EQ(list.topics.size(), 2u);
  EXPECT_EQ(list.topics[0].band.warn.high, 12);
  EXPECT_EQ(list.topics[0].band.error.low, 5);
  EXPECT_FALSE(list.topics[0].band.error.high.has_value());
  EXPECT_EQ(list.topics[0].window, seconds(4));
  EXPECT_EQ(list.topics[0].band.staleness, milliseconds(1500));
  EXPECT_FALSE(list.topics[0].wall_time);
  EXPECT_TRUE(list.topics[1].wall_time);
  EXPECT_EQ(list.topics[1].window, seconds(1));
  ASSERT_TRUE(list.navigation.has_value());
  EXPECT_EQ(list.navigation->blocked, seconds(7));
  EXPECT_EQ(list.sources.at(0).period, milliseconds(500));
  EXPECT_TRUE(config.ForConfiguration("charging").nodes.empty());
  EXPECT_FALSE(config.ForConfiguration("charging").navigation.has_value());
  EXPECT_TRUE(config.ForConfiguration("unheard-of").nodes.empty());
}

TEST_F(MonitorConfigTest, ReadsWhatTheMessagesOfATopicAreAndWhatIsOptional) {
  const MonitorConfig config = Read(R"(
configurations:
  operating:
    nodes: [{node: /base}, {node: /camera, optional: yes}]
    topics: [{topic: /scan, node: /lidar, content: laser_scan}, {topic: /odom, node: /base},
             {topic: /sonar, node: /sonar, content: range, optional: yes}]
)");
  EXPECT_EQ(Errors(), "");
  const WatchList& list = config.ForConfiguration("operating");
  EXPECT_EQ(list.topics.at(0).content, Content::kLaserScan);
  EXPECT_EQ(list.topics.at(1).content, Content::kAny);
  EXPECT_FALSE(list.topics.at(1).is_optional);
  EXPECT_EQ(list.topics.at(2).content, Content::kRange);
  EXPECT_TRUE(list.topics.at(2).is_optional);
  EXPECT_FALSE(list.nodes.at(0).is_optional);
  EXPECT_TRUE(list.nodes.at(1).is_optional);
}

TEST_F(MonitorConfigTest, WhatIsTakenFromStatisticsIsNotRead) {
  Read(R"(
configurations:
  operating:
    topics: [{topic: /scan, node: /lidar, content: laser_scan, by: statistics}]
)");
  EXPECT_THAT(Errors(), testing::HasSubstr("cannot be seen \"by: statistics\""));
}

TEST_F(MonitorConfigTest, ReadsTheSectionsOfEnergyMovementAndComputers) {
  const MonitorConfig config = Read(R"(
health_aggregator: {diagnostics: 2}
system:
  - window: 3
    cpu: {load: {error: [none, 0.5]}}
  - host: jetson
    disks: [{path: /data, used: {error: [none, 0.99]}}]
    network: [{interface: eth0, speed: 100}]
    clocks: [{host: main}]
    hosts: [{host: main, address: 10.0.0.1, port: 80}]
    processes: [{node: /camera, memory: {error: [none, 900], warn: [none, 800]}}]
configurations:
  operating:
    topics: [{topic: /camera, node: /driver, by: statistics, warn: [25, 35], consecutive: 3}]
    localization: {topic: /localization/state, node: /l, since_confirmed: {error: [none, 30]}}
    transforms: [{parent: map, child: odom, node: /l, age: {staleness: 9}}]
    loggers: [{name: record, path: run.log, staleness: 7}]
    diagnostics: {staleness: 6}
    battery: {topic: /battery_state, node: /base, voltage: {error: [23, 30]},
              dock: {x: 1, y: 2, way: /way}, model: {capacity: 40}}
    charging: {within: 4}
    docking: {action: /docking, node: /docking, failures: {error: [none, 5]}}
    emergency_stop: {topic: /stop}
    sources: [{source: /jetson_system_monitor, host: jetson}]
)");
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(config.diagnostics_period, seconds(2));
  const WatchList& list = config.ForConfiguration("operating");
  EXPECT_TRUE(list.topics.at(0).by_statistics);
  EXPECT_EQ(list.topics[0].band.consecutive, 3);
  EXPECT_EQ(list.topics[0].band.staleness, seconds(10));
  EXPECT_EQ(list.localization->since_confirmed.error.high, 30);
  EXPECT_EQ(list.localization->since_confirmed.warn.high, 10);  // by default
  EXPECT_EQ(list.transforms.at(0).age.staleness, seconds(9));
  EXPECT_EQ(list.loggers.at(0).path, "run.log");
  EXPECT_EQ(list.diagnostics->staleness, seconds(6));
  EXPECT_EQ(list.battery->voltage.error.low, 23);
  EXPECT_EQ(list.battery->dock->y, 2);
  EXPECT_EQ(list.battery->dock->way, "/way");
  EXPECT_EQ(list.battery->model.capacity, 40);
  EXPECT_EQ(list.charging->within, seconds(4));
  EXPECT_EQ(list.docking->failures.error.high, 5);
  EXPECT_EQ(list.emergency_stop->topic, "/stop");
  EXPECT_EQ(list.sources.at(0).host, "jetson");
  ASSERT_NE(config.ForHost("any"), nullptr);
  EXPECT_EQ(config.ForHost("any")->cpu_load.error.high, 0.5);
  EXPECT_EQ(config.ForHost("any")->window, seconds(3));
  const SystemWatch* jetson = config.ForHost("jetson");
  ASSERT_NE(jetson, nullptr);
  EXPECT_EQ(jetson->disks.at(0).used.error.high, 0.99);
  EXPECT_EQ(jetson->interfaces.at(0).speed, 100);
  EXPECT_EQ(jetson->clocks.at(0).address, "main");
  EXPECT_EQ(jetson->clocks[0].offset.error.low, -1);
  EXPECT_EQ(jetson->hosts.at(0).port, 80);
  EXPECT_EQ(jetson->processes.at(0).memory.error.high, 900);
  EXPECT_EQ(MonitorConfig().ForHost("any"), nullptr);
}

TEST_F(MonitorConfigTest, EverySectionIsStrict) {
  Read(R"(configurations:
  operating:
    batery: {topic: /battery_state, node: /base}
    charging: {within: 4}
    transforms: [{parent: map, child: odom}, {parent: map, child: odom}]
    loggers: [{name: a}, {name: b, path: x, topic: /y}]
    publishers: [{topic: /a, nodes: [a]}, {topic: /b}]
    localization: {topic: /l, node: /l, scor: {warn: [1, 2]}}
    docking: {action: docking, node: /docking, failures: {warn: [none, 9], error: [none, 5]}}
system: [{cpu: {lod: {}}, disks: [{path: /, used: {consecutive: 0}}], clocks: [{port: 99}]},
         {host: a}, {host: a}]
)");
  EXPECT_THAT(Errors(),
              HasSubstr(":3:5: error: unknown key \"batery\" (did you mean \"battery\"?)"));
  EXPECT_THAT(Errors(), HasSubstr("\"charging\" needs \"battery\""));
  EXPECT_THAT(Errors(), HasSubstr("\"map -> odom\" is listed twice"));
  EXPECT_THAT(Errors(), HasSubstr(":6:15: error: expected either \"path\" or \"topic\""));
  EXPECT_THAT(Errors(), HasSubstr(":6:26: error: expected either \"path\" or \"topic\""));
  EXPECT_THAT(Errors(), HasSubstr("expected a ROS name with slash, got \"a\""));
  EXPECT_THAT(Errors(), HasSubstr("\"nodes\" names nobody"));
  EXPECT_THAT(Errors(), HasSubstr("unknown key \"scor\" (did you mean \"score\"?)"));
  EXPECT_THAT(Errors(), HasSubstr("\"action\": expected a ROS name with slash"));
  EXPECT_THAT(Errors(), HasSubstr("\"warn\" is not within \"error\""));
  EXPECT_THAT(Errors(), HasSubstr("unknown key \"lod\" (did you mean \"load\"?)"));
  EXPECT_THAT(Errors(), HasSubstr("\"consecutive\": 0 is not within 1 and 1000"));
  EXPECT_THAT(Errors(), HasSubstr("\"host\" is missing"));
  EXPECT_THAT(Errors(), HasSubstr("\"a\" is listed twice"));
}

// A configuration that nobody has thought of has a computer, too.
TEST_F(MonitorConfigTest, ComputersAreNoMatterOfTheConfiguration) {
  Read("configurations: {operating: {system: [{}]}}");
  EXPECT_THAT(Errors(), HasSubstr("unknown key \"system\""));
}

TEST_F(MonitorConfigTest, ReportsEverythingAtOnceWithPlaceAndHint) {
  Read(R"(report_perod: 1
initial: oprating
configurations:
  operating:
    nodes: [{node: a}, {node: /b}, {node: /b}]
    topics:
      - {topic: /x, node: /b, warn: [3, 2]}
      - {topic: /y, node: /b, warn: [1], error: [a, 2]}
      - {topic: /z, node: /b, warn: [1, 9], error: [2, 8], time: ross}
      - {topic: /z}
    sources: [{source: /m, period: -1}]
)");
  EXPECT_THAT(Errors(), HasSubstr(":1:1: error: unknown key \"report_perod\" (did you mean "
                                  "\"report_period\"?)"));
  EXPECT_THAT(Errors(), HasSubstr("unknown configuration \"oprating\" (did you mean "
                                  "\"operating\"?)"));
  EXPECT_THAT(Errors(), HasSubstr(":5:20: error: \"node\": expected a ROS name with slash"));
  EXPECT_THAT(Errors(), HasSubstr("\"/b\" is listed twice"));
  EXPECT_THAT(Errors(), HasSubstr("low is not below high"));
  EXPECT_THAT(Errors(), HasSubstr("expected [low, high]"));
  EXPECT_THAT(Errors(), HasSubstr("expected a number or none, got \"a\""));
  EXPECT_THAT(Errors(), HasSubstr("\"warn\" is not within \"error\""));
  EXPECT_THAT(Errors(), HasSubstr("\"ross\" is none of ros, wall (did you mean \"ros\"?)"));
  EXPECT_THAT(Errors(), HasSubstr("-1 is not within"));
}

// Both files must speak of the same robot.
TEST_F(MonitorConfigTest, TheShippedFileIsRightAndFitsTheShippedProcesses) {
  const std::string folder = SourceFolder() + "/robot_app/config/";
  const MonitorConfig monitors = LoadMonitorConfig(folder + "monitors.yaml", diagnostics_);
  const processes::RobotConfig robot = processes::LoadRobotConfig(
      folder + "robot.yaml", {{"bin", "b"}, {"config", folder}, {"record", "/tmp/run"}},
      diagnostics_);
  ASSERT_EQ(Errors(), "");
  EXPECT_EQ(monitors.lists.size(), robot.configurations.size());
  for (const processes::Configuration& configuration : robot.configurations) {
    std::vector<std::string> nodes = {"/supervisor"};  // who starts the others
    const auto may_be_watched = [&](const auto& watch) {
      if (!watch.is_optional) return std::count(nodes.begin(), nodes.end(), watch.node) > 0;
      return std::any_of(robot.processes.begin(), robot.processes.end(),
                         [&](const auto& process) { return process.node == watch.node; });
    };
    for (const std::size_t process : configuration.processes) {
      nodes.push_back(robot.processes[process].node);
    }
    const WatchList& list = monitors.ForConfiguration(configuration.name);
    EXPECT_FALSE(list.nodes.empty()) << configuration.name;
    for (const NodeWatch& watch : list.nodes) EXPECT_TRUE(may_be_watched(watch)) << watch.node;
    for (const TopicWatch& watch : list.topics) EXPECT_TRUE(may_be_watched(watch)) << watch.topic;
    for (const SourceWatch& watch : list.sources) {
      EXPECT_THAT(nodes, testing::Contains(watch.source));
    }
    if (list.navigation) {
      EXPECT_THAT(nodes, testing::Contains(list.navigation->node));
    }
  }
}

}  // namespace
}  // namespace coppice::robot::monitoring
