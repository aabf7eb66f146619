// What monitoring costs and how fast it is: 60 real ROS nodes with 40 topics, all monitors and the
// aggregator, on a ROS master of its own.
//
//   coppice_monitoring_bench [SECONDS]     default 30
//
// Prints the processor time of every monitor as a share of one core, and how long it takes from the
// death of a node (SIGKILL, SIGSTOP) to its error on /monitoring. Exit status 1 if the sum is above
// 3 % or one death was seen later than 2 s.
#include <actionlib_msgs/GoalStatusArray.h>
#include <coppice_msgs/Health.h>
#include <coppice_msgs/LocalizationState.h>
#include <coppice_msgs/NavigationState.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/BatteryState.h>
#include <std_msgs/Bool.h>
#include <sys/wait.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/common/node_probe.h"
#include "robot_app/monitoring/system/proc_files.h"
#include "robot_app/processes/launch/process_launcher.h"
#include "robot_app/processes/launch/ros_master.h"
#include "tests/support/folders.h"

namespace coppice::robot::monitoring {
namespace {

constexpr int kNodes = 60;
constexpr int kTopics = 40;
constexpr double kRate = 10;         // Hz, of each topic
constexpr double kMostShare = 0.03;  // of one core
constexpr double kMostDelay = 2;     // s
constexpr int kDeaths = 5;           // of each kind

std::string NodeName(int i) { return "/bench_node_" + std::to_string(i); }
std::string TopicName(int i) { return "/bench_topic_" + std::to_string(i); }

std::string Config() {
  std::string nodes, topics;
  for (int i = 0; i < kNodes; ++i) nodes += "      - {node: " + NodeName(i) + "}\n";
  for (int i = 0; i < kTopics; ++i) {
    topics += "      - {topic: " + TopicName(i) + ", node: " + NodeName(i) +
              ", warn: [8, 12], error: [5, 20]}\n";
  }
  return "configurations:\n  operating:\n    nodes:\n" + nodes + "    topics:\n" + topics +
         R"(    navigation: {topic: /navigation/state, node: /bench}
    localization: {topic: /localization/state, node: /bench}
    transforms: [{parent: map, child: odom}, {parent: odom, child: base_link}]
    diagnostics: {}
    battery: {topic: /battery_state, node: /bench, dock: {x: 0, y: 0}}
    charging: {}
    docking: {action: /docking, node: /bench}
    emergency_stop: {topic: /emergency_stop, staleness: 5}
    sources: [{source: /node_monitor}, {source: /topic_monitor}, {source: /navigation_monitor},
              {source: /power_monitor}, {source: /system_monitor}]
system:
  - cpu: {load: {warn: [none, none], error: [none, none]}}
    disks: [{path: /}]
    network: [{interface: lo}]
    hosts: [{host: here, address: 127.0.0.1}]
    processes: [{node: /bench_node_0}, {node: /bench_node_1}]
)";
}

// What a robot publishes besides: battery, states and transforms, at usual rates.
class Robot {
 public:
  explicit Robot(ros::NodeHandle& node) : node_(node) {
    Every<sensor_msgs::BatteryState>("/battery_state", 2, [](auto& message) {
      message.voltage = 25;
      message.current = -6;
      message.charge = 60;
      message.percentage = 0.8f;
    });
    Every<coppice_msgs::NavigationState>("/navigation/state", 2, [](auto&) {});
    Every<coppice_msgs::LocalizationState>("/localization/state", 2,
                                           [](auto& message) { message.score = 1; });
    Every<actionlib_msgs::GoalStatusArray>("/docking/status", 5, [](auto&) {});
    Every<std_msgs::Bool>("/emergency_stop", 1, [](auto&) {});
    Every<tf2_msgs::TFMessage>("/tf", 20, [](auto& message) {
      for (const auto& [parent, child] :
           {std::pair("map", "odom"), std::pair("odom", "base_link")}) {
        geometry_msgs::TransformStamped transform;
        transform.header.stamp = ros::Time::now();
        transform.header.frame_id = parent;
        transform.child_frame_id = child;
        transform.transform.rotation.w = 1;
        message.transforms.push_back(transform);
      }
    });
  }

 private:
  template <class Message, class Fill>
  void Every(const std::string& topic, double rate, Fill fill) {
    const ros::Publisher publisher = node_.advertise<Message>(topic, 10);
    timers_.push_back(node_.createWallTimer(ros::WallDuration(1 / rate),
                                            [publisher, fill](const ros::WallTimerEvent&) {
                                              Message message;
                                              fill(message);
                                              publisher.publish(message);
                                            }));
  }
  ros::NodeHandle& node_;
  std::vector<ros::WallTimer> timers_;
};

class Bench {
 public:
  explicit Bench(const std::string& folder) : launcher_(folder), config_(folder + "/bench.yaml") {
    std::ofstream(config_) << Config();
    NodeProbe::SilenceLibrary();
    master_ = processes::FindOrStartMaster(0, launcher_, std::chrono::seconds(20)).value();
    setenv("ROS_MASTER_URI", master_.Uri().c_str(), 1);
    setenv("ROS_IP", "127.0.0.1", 1);
  }
  ~Bench() {
    subscriber_.shutdown();
    ros::shutdown();
    for (const auto& [name, pid] : pids_) End(pid);
    if (master_.pid != 0) End(master_.pid);
  }

  bool Start() {
    for (int i = 0; i < kNodes; ++i) StartNode(i);
    Launch("health-aggregator",
           {BinaryFolder() + "/bin/coppice-health-aggregator", "--config", config_});
    for (const char* name : {"node", "topic", "navigation", "power", "system"}) {
      const std::string monitor = std::string(name) + "-monitor";
      Launch(monitor, {BinaryFolder() + "/bin/coppice-" + monitor, "--config", config_});
    }
    int no_arguments = 0;
    ros::init(no_arguments, nullptr, "bench", ros::init_options::NoSigintHandler);
    node_.emplace();
    robot_.emplace(*node_);
    subscriber_ = node_->subscribe<coppice_msgs::Health>(
        "/monitoring", 100,
        [this](const coppice_msgs::Health::ConstPtr& message) { health_ = *message; });
    if (WaitFor([this] { return health_.entries.size() > kNodes + kTopics && Bad().empty(); },
                90)) {
      return true;
    }
    for (const std::string& line : Bad()) std::fprintf(stderr, "not well: %s\n", line.c_str());
    return false;
  }

  // Share of one core of all monitors together; prints each.
  double MeasureCost(double seconds) {
    std::map<std::string, double> before;
    for (const auto& [name, pid] : Monitors()) before[name] = CpuTime(pid);
    const ros::WallTime begin = ros::WallTime::now();
    WaitFor([] { return false; }, seconds);
    const double elapsed = (ros::WallTime::now() - begin).toSec();
    double sum = 0;
    for (const auto& [name, pid] : Monitors()) {
      const double share = (CpuTime(pid) - before[name]) / elapsed;
      std::printf("  %-20s %5.2f %% of one core\n", name.c_str(), 100 * share);
      sum += share;
    }
    std::printf("  %-20s %5.2f %% (most %.0f %%), %zu entries, over %.0f s\n", "sum", 100 * sum,
                100 * kMostShare, health_.entries.size(), elapsed);
    return sum;
  }

  // Longest time until the error of a node that gets this signal [s].
  double MeasureDeaths(int signal, const char* name) {
    double longest = 0;
    for (int i = 0; i < kDeaths; ++i) {
      const int node = i * (kNodes - 1) / (kDeaths - 1);
      const int pid = pids_.at(NodeName(node));
      const ros::WallTime begin = ros::WallTime::now();
      kill(pid, signal);
      WaitFor([&] { return Level(NodeName(node)) >= coppice_msgs::HealthEntry::ERROR; }, 10);
      longest = std::max(longest, (ros::WallTime::now() - begin).toSec());
      End(pid);
      StartNode(node);
      WaitFor([&] { return Level(NodeName(node)) == coppice_msgs::HealthEntry::OK; }, 20);
    }
    std::printf("  %-20s seen after %.2f s at most (bar %.0f s), %d times\n", name, longest,
                kMostDelay, kDeaths);
    return longest;
  }

 private:
  void Launch(const std::string& name, std::vector<std::string> command) {
    processes::ProcessConfig config;
    config.name = name;
    config.command = std::move(command);
    config.log = "bench.log";
    pids_[name] = launcher_.Start(config).value();
  }

  // Nodes that have no topic of the list have one that is hardly used.
  void StartNode(int i) {
    const bool talks = i < kTopics;
    Launch(NodeName(i),
           {BinaryFolder() + "/tests/bin/test_talker", "__name:=" + NodeName(i).substr(1),
            "_topic:=" + (talks ? TopicName(i) : "/quiet_" + std::to_string(i)),
            "_rate:=" + std::to_string(talks ? kRate : 0.1)});
  }

  void End(int pid) {
    launcher_.Signal(pid, SIGKILL);
    waitpid(pid, nullptr, 0);
  }

  static bool WaitFor(const std::function<bool()>& condition, double seconds) {
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(seconds);
    while (!condition()) {
      if (ros::WallTime::now() > deadline) return false;
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
    }
    return true;
  }

  std::map<std::string, int> Monitors() const {
    std::map<std::string, int> monitors;
    for (const auto& [name, pid] : pids_) {
      if (name.front() != '/') monitors[name] = pid;
    }
    return monitors;
  }
  static double CpuTime(int pid) {
    const auto usage = ReadProcessUsage("", pid);
    return usage ? usage->cpu_time : 0;
  }

  int Level(const std::string& node) const {
    for (const coppice_msgs::HealthEntry& entry : health_.entries) {
      if (entry.monitor == "node" && entry.subject == node) return entry.level;
    }
    return -1;
  }
  std::vector<std::string> Bad() const {
    std::vector<std::string> bad;
    for (const coppice_msgs::HealthEntry& entry : health_.entries) {
      if (entry.level < coppice_msgs::HealthEntry::ERROR) continue;
      bad.push_back(entry.monitor + " " + entry.subject + ": " + entry.message);
    }
    return bad;
  }

  processes::PosixLauncher launcher_;
  std::string config_;
  processes::RosMaster master_;
  std::map<std::string, int> pids_;
  std::optional<ros::NodeHandle> node_;
  std::optional<Robot> robot_;
  ros::Subscriber subscriber_;
  coppice_msgs::Health health_;
};

int Run(double seconds) {
  const std::string folder = std::filesystem::temp_directory_path() /
                             ("coppice_monitoring_bench_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  bool ok = false;
  {
    Bench bench(folder);
    if (!bench.Start()) {
      std::fprintf(stderr, "the graph did not come up\n");
    } else {
      std::printf("%d nodes, %d topics at %.0f Hz\n", kNodes, kTopics, kRate);
      ok = bench.MeasureCost(seconds) <= kMostShare;
      ok = bench.MeasureDeaths(SIGKILL, "killed node") <= kMostDelay && ok;
      ok = bench.MeasureDeaths(SIGSTOP, "hung node") <= kMostDelay && ok;
    }
  }
  std::filesystem::remove_all(folder);
  return ok ? 0 : 1;
}

}  // namespace
}  // namespace coppice::robot::monitoring

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::strtod(argv[1], nullptr) : 30;
  if (!(seconds > 0)) {
    std::fprintf(stderr, "usage: coppice_monitoring_bench [SECONDS]\n");
    return 2;
  }
  return coppice::robot::monitoring::Run(seconds);
}
