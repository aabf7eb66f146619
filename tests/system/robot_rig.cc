#include "tests/system/robot_rig.h"

#include <coppice_msgs/InjectFault.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/BatteryState.h>
#include <signal.h>
#include <std_msgs/String.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "robot_app/processes/launch/ros_master.h"
#include "tests/support/folders.h"

namespace coppice::robot {
namespace {

namespace fs = std::filesystem;

constexpr double kStartPatience = 120;  // s, wall
constexpr std::chrono::seconds kStopPatience{30};

const fs::path kSource = SourceFolder();
const fs::path kBinary = BinaryFolder();

// Each test program has six of its own: the ROS master's, four of the live view, the page's.
int MasterPort() {
  static const int port = processes::FreePort(6);
  return port;
}
std::string MasterUri() { return "http://127.0.0.1:" + std::to_string(MasterPort()); }

std::string Contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void Replace(const fs::path& file, const std::string& from, const std::string& to) {
  std::string text = Contents(file);
  const std::size_t at = text.find(from);
  if (at == std::string::npos) {
    throw std::runtime_error(file.string() + " has no \"" + from + "\" to be replaced");
  }
  std::ofstream(file, std::ios::binary) << text.replace(at, from.size(), to);
}

std::string Tail(const fs::path& file) {
  const std::string text = Contents(file);
  return text.size() > 2000 ? text.substr(text.size() - 2000) : text;
}

template <class Message>
StampedPoint PlaceOf(const Message& message, const geometry_msgs::Pose& pose) {
  return {message.header.stamp.toSec(), pose.position.x, pose.position.y};
}

int PidOfMaster() {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  return ros::master::execute("getPid", request, response, payload, false)
             ? static_cast<int>(payload)
             : 0;
}

}  // namespace

RobotRig::RobotRig(RigOptions options) : options_(std::move(options)) {
  folder_ = kBinary / "tests/system" / options_.name;
}

RobotRig::~RobotRig() {
  Stop();
  if (!testing::UnitTest::GetInstance()->Failed()) {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
}

void RobotRig::LayOutFolder() {
  fs::remove_all(folder_);
  fs::create_directories(folder_ / "logs");
  fs::create_directories(folder_ / "robot_app");
  fs::copy(kSource / "robot_app/config", config(), fs::copy_options::recursive);
  fs::create_directory_symlink(kSource / "robot_app/simulation", folder_ / "robot_app/simulation");
  fs::create_directory_symlink(kSource / "trees", folder_ / "trees");
  if (!options_.start.empty()) {
    Replace(config() / "robot.yaml", "\"_seed:=", "\"_start:=" + options_.start + "\", \"_seed:=");
    Replace(config() / "robot.yaml", "\"${bin}/coppice-localization\"",
            "\"${bin}/coppice-localization\", \"_start_pose:=" + options_.start + "\"");
  }
  // Others may use the cores.
  Replace(config() / "monitors.yaml", "load: {warn: [none, 0.9], error: [none, 0.97]",
          "load: {warn: [none, none], error: [none, none]");
  for (const ConfigEdit& edit : options_.edits) Replace(config() / edit.file, edit.from, edit.to);
  LinkPrograms();
}

void RobotRig::LinkPrograms() {
  fs::create_directories(folder_ / "bin");
  for (const auto& program : fs::directory_iterator(kBinary / "bin")) {
    fs::create_symlink(program.path(), folder_ / "bin" / program.path().filename());
  }
  for (const auto& [name, path] : options_.programs) {
    fs::remove(folder_ / "bin" / name);
    fs::create_symlink(path, folder_ / "bin" / name);
  }
}

std::vector<std::string> RobotRig::Command() const {
  std::vector<std::string> command = {(kBinary / "bin/coppice-supervisor").string(),
                                      "--config",
                                      (config() / "robot.yaml").string(),
                                      "--port",
                                      std::to_string(MasterPort()),
                                      "--address",
                                      options_.address,
                                      "--logs",
                                      (folder_ / "logs").string()};
  auto variables = options_.variables;
  variables.emplace_back("bin", (folder_ / "bin").string());
  variables.emplace_back("source", kSource.string());
  variables.emplace_back("record", folder_.string());
  variables.emplace_back("live_port", std::to_string(MasterPort() + 1));
  variables.emplace_back("page_port", std::to_string(MasterPort() + 5));
  variables.emplace_back("tablet_port", "0");  // any
  // Most tests run faster than real time, where nobody can be followed.
  const auto is_perception = [](const auto& variable) { return variable.first == "perception"; };
  if (std::none_of(variables.begin(), variables.end(), is_perception)) {
    variables.emplace_back("perception", "no");
  }
  for (const auto& [name, value] : variables) {
    command.push_back("--set");
    command.push_back(name + "=" + value);
  }
  return command;
}

bool RobotRig::Start() {
  LayOutFolder();
  setenv("ROS_MASTER_URI", MasterUri().c_str(), 1);
  setenv("ROS_IP", options_.address.c_str(), 1);
  state_ = {};
  const Instant begin = Now();
  supervisor_ = ChildProcess(Command(), log("supervisor"), options_.environment);
  if (Join() && WaitUntilNominal(kStartPatience).has_value()) return true;
  ADD_FAILURE() << "the robot did not start:\n" << TimelineSince(begin) << Tail(log("supervisor"));
  return false;
}

// A process can join one ROS graph in its life; therefore the port is always the same.
bool RobotRig::Join() {
  if (!ros::isInitialized()) {
    int no_arguments = 0;
    ros::init(no_arguments, nullptr, "robot_rig",
              ros::init_options::NoSigintHandler | ros::init_options::NoRosout |
                  ros::init_options::AnonymousName);
  }
  const double deadline = ros::WallTime::now().toSec() + kStartPatience;
  while (PidOfMaster() == 0) {
    if (!supervisor_.IsRunning() || ros::WallTime::now().toSec() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  if (!node_) {
    ros::start();
    node_ = std::make_unique<ros::NodeHandle>();
  }
  spinner_ = std::make_unique<ros::AsyncSpinner>(1);
  spinner_->start();
  FollowMaster();
  return true;
}

// A new master knows nothing of us.
void RobotRig::FollowMaster() {
  const int pid = PidOfMaster();
  if (pid == 0 || pid == master_pid_) return;
  master_pid_ = pid;
  Subscribe();
}

template <class Message>
void RobotRig::Watch(const std::string& topic,
                     std::function<void(const Message&, const Instant&)> update) {
  const boost::function<void(const boost::shared_ptr<Message const>&)> callback =
      [this, update](const boost::shared_ptr<Message const>& message) {
        {
          const std::lock_guard<std::mutex> lock(mutex_);
          update(*message, {ros::WallTime::now().toSec(), state_.now().ros});
        }
        changed_.notify_all();
      };
  subscribers_.push_back(node_->subscribe<Message>(topic, 100, callback));
}

void RobotRig::Subscribe() {
  for (ros::Subscriber& subscriber : subscribers_) subscriber.shutdown();
  subscribers_.clear();
  // Not /clock: roscpp has a subscription of its own to that, so that ours would not be made anew.
  Watch<nav_msgs::Odometry>("/odom", [this](const auto& message, const Instant& now) {
    state_.OnClock({now.wall, message.header.stamp.toSec()});
  });
  Watch<coppice_msgs::Health>("/monitoring", [this](const auto& message, const Instant& now) {
    state_.OnHealth(message, now);
  });
  Watch<coppice_msgs::ProcessStates>("/processes", [this](const auto& message, const Instant& now) {
    for (const auto& process : message.processes) {
      if (process.pid > 0) pids_.insert(process.pid);
    }
    state_.OnProcesses(message, now);
  });
  Watch<coppice_msgs::HelpRequests>(
      "/assistance/requests",
      [this](const auto& message, const Instant& now) { state_.OnRequests(message, now); });
  Watch<coppice_msgs::RecoveryEvent>(
      "/recovery/events",
      [this](const auto& message, const Instant& now) { state_.OnRecovery(message, now); });
  Watch<std_msgs::String>("/coppice/application", [this](const auto& message, const Instant& now) {
    state_.OnApplication(message.data, now);
  });
  Watch<sensor_msgs::BatteryState>(
      "/battery_state",
      [this](const auto& message, const Instant& now) { state_.OnBattery(message.current, now); });
  Watch<geometry_msgs::PoseStamped>("/simulation/truth",
                                    [this](const auto& message, const Instant&) {
                                      state_.OnTruth(PlaceOf(message, message.pose));
                                    });
  Watch<geometry_msgs::PoseWithCovarianceStamped>(
      "/localization/pose", [this](const auto& message, const Instant&) {
        state_.OnBelief(PlaceOf(message, message.pose.pose));
      });
}

Instant RobotRig::Now() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {ros::WallTime::now().toSec(), state_.now().ros};
}

bool RobotRig::WaitFor(const std::function<bool(const RobotState&)>& condition, double seconds) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  auto next_look = std::chrono::steady_clock::now();
  std::unique_lock<std::mutex> lock(mutex_);
  while (!condition(state_)) {
    const auto now = std::chrono::steady_clock::now();
    if (now >= deadline || !supervisor_.IsRunning()) return false;
    if (now >= next_look) {
      next_look = now + std::chrono::seconds(1);
      lock.unlock();
      FollowMaster();
      lock.lock();
      continue;
    }
    changed_.wait_for(lock, std::chrono::milliseconds(200));
  }
  return true;
}

std::optional<Instant> RobotRig::WaitUntilNominal(double seconds, double hold) {
  const Instant called = Now();
  Instant since;
  const auto nominal = [&](const RobotState& state) {
    if (!state.nominal_since()) return false;
    since = state.nominal_since()->wall > called.wall ? *state.nominal_since() : called;
    return state.now().ros - since.ros >= hold;
  };
  if (WaitFor(nominal, seconds)) return since;
  std::string problems;
  for (const std::string& problem : With([](const RobotState& s) { return s.Problems(); })) {
    problems += "\n  " + problem;
  }
  ADD_FAILURE() << "not nominal within " << seconds << " s:" << problems;
  return std::nullopt;
}

bool RobotRig::Inject(const std::string& fault, const std::string& target, double value,
                      double duration) {
  coppice_msgs::InjectFault service;
  service.request.fault = fault;
  service.request.target = target;
  service.request.value = value;
  service.request.duration = duration;
  const double deadline = ros::WallTime::now().toSec() + 20;
  while (!ros::service::call("/simulation/inject_fault", service) || !service.response.ok) {
    if (ros::WallTime::now().toSec() > deadline) {
      ADD_FAILURE() << fault << " " << target << " was refused: " << service.response.message;
      return false;
    }
    WaitFor([](const RobotState&) { return false; }, 0.2);
  }
  Note("injected " + fault + (target.empty() ? "" : " " + target));
  return true;
}

bool RobotRig::Signal(const std::string& process, int signal) {
  const int pid = With([&](const RobotState& state) { return state.ReadyPid(process); });
  const bool sent = pid > 0 && kill(pid, signal) == 0;
  EXPECT_TRUE(sent) << process << " (pid " << pid << ")";
  Note("signal " + std::to_string(signal) + " to " + process);
  return sent;
}

void RobotRig::Note(const std::string& text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.Note(text, {ros::WallTime::now().toSec(), state_.now().ros});
}

std::string RobotRig::TimelineSince(const Instant& since) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::ostringstream text;
  for (const Event& event : state_.events()) {
    if (event.at.wall >= since.wall) text << ToString(event, since) << "\n";
  }
  return text.str();
}

fs::path RobotRig::log(const std::string& process) const {
  return folder_ / "logs" / (process + ".log");
}

std::string RobotRig::Logged(const std::string& process) const { return Contents(log(process)); }

void RobotRig::Stop() {
  if (supervisor_.pid() == 0) return;
  supervisor_.Stop(kStopPatience);
  spinner_.reset();  // from here on nobody writes what the robot told
  EndWhatIsLeft();
  supervisor_ = {};
}

// A process is ours if our master's address is in its environment.
void RobotRig::EndWhatIsLeft() {
  for (const int pid : pids_) {
    if (!ProcessExists(pid)) continue;
    const std::string environment = Contents("/proc/" + std::to_string(pid) + "/environ");
    if (environment.find("ROS_MASTER_URI=" + MasterUri()) == std::string::npos) continue;
    ADD_FAILURE() << "process " << pid << " was left behind";
    kill(pid, SIGKILL);
  }
  pids_.clear();
}

}  // namespace coppice::robot
