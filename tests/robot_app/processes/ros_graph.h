// A private ROS graph for a test: its own master at a free port, programs that end with the test,
// and waiting for events with a deadline.
#ifndef COPPICE_TESTS_ROBOT_APP_PROCESSES_ROS_GRAPH_H_
#define COPPICE_TESTS_ROBOT_APP_PROCESSES_ROS_GRAPH_H_

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robot_app/common/node_probe.h"
#include "robot_app/processes/launch/ros_master.h"
#include "tests/robot_app/processes/temporary.h"
#include "tests/support/folders.h"

namespace coppice::robot::processes {

inline const std::string kPrograms = BinaryFolder() + "/bin/";
inline const std::string kTestPrograms = BinaryFolder() + "/tests/bin/";

class RosGraph {
 public:
  /// With a master of its own.
  explicit RosGraph(const std::string& log_folder = Temporary("ros_graph"))
      : launcher_(log_folder) {
    NodeProbe::SilenceLibrary();
    master_ = FindOrStartMaster(0, launcher_, std::chrono::seconds(60)).value();
  }

  /// For a graph whose master somebody else starts, at OwnPort(); Join it when it is there. The
  /// graphs of several tests of a program, one after the other, are one graph to it.
  struct WithoutMaster {};
  RosGraph(WithoutMaster, const std::string& log_folder) : launcher_(log_folder) {
    NodeProbe::SilenceLibrary();
  }

  /// A program can join one graph in its life: the one that all tests of this program share.
  static RosGraph& Shared() {
    static RosGraph graph;
    return graph;
  }

  /// Of this test program, always the same.
  static int OwnPort() {
    static const int port = FreePort();
    return port;
  }

  ~RosGraph() {
    EndPrograms();
    if (master_.pid != 0) Kill(master_.pid, SIGKILL);
  }

  void EndPrograms() {
    while (!started_.empty()) Kill(*started_.begin(), SIGKILL);
  }

  /// Makes this program a node of the graph.
  void Join(const std::string& uri) {
    UseFor(uri);
    if (!ros::isInitialized()) {
      int no_arguments = 0;
      ros::init(no_arguments, nullptr, "test",
                ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
      ros::start();  // until the end of the program: it cannot be done twice
    }
    node_ = std::make_unique<ros::NodeHandle>();
  }

  ros::NodeHandle& node() {
    if (!node_) Join(master_.Uri());
    return *node_;
  }
  const NodeAddress& master() const { return master_.address; }

  /// Starts a program that uses this graph; it ends with the graph at the latest.
  int Start(const std::string& name, std::vector<std::string> command) {
    if (master_.pid != 0) UseFor(master_.Uri());
    ProcessConfig config;
    config.name = name;
    config.command = std::move(command);
    config.log = name + ".log";
    const Expected<int> pid = launcher_.Start(config);
    EXPECT_EQ(pid.problem(), "");
    return pid ? *started_.insert(*pid).first : 0;
  }

  // Sends a deadly signal and waits for the end. Returns the wait status.
  int Kill(int pid, int signal) {
    started_.erase(pid);
    launcher_.Signal(pid, signal);
    int wait_status = 0;
    waitpid(pid, &wait_status, 0);
    return wait_status;
  }

  /// Waits until a program of this graph ends by itself. Returns the wait status, or nothing when
  /// the deadline has come first.
  std::optional<int> WaitForEnd(int pid) {
    int wait_status = 0;
    if (!WaitFor([&] { return waitpid(pid, &wait_status, WNOHANG) == pid; })) return std::nullopt;
    started_.erase(pid);
    return wait_status;
  }

  /// Stops a program of this graph as if it hung; returns when all its threads stand.
  static void Hang(int pid) {
    kill(pid, SIGSTOP);
    waitpid(pid, nullptr, WUNTRACED);
  }

  // Handles ROS callbacks until it is true; false when the deadline has come first.
  bool WaitFor(const std::function<bool()>& condition, double seconds = 60) {
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(seconds);
    while (!condition()) {
      if (ros::WallTime::now() > deadline) return false;
      if (!node_) ros::WallDuration(0.02).sleep();
      if (node_) ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
    }
    return true;
  }

 private:
  static void UseFor(const std::string& uri) {
    setenv("ROS_MASTER_URI", uri.c_str(), 1);
    setenv("ROS_IP", "127.0.0.1", 1);
  }

  PosixLauncher launcher_;
  RosMaster master_;
  std::unique_ptr<ros::NodeHandle> node_;
  std::set<int> started_;
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_TESTS_ROBOT_APP_PROCESSES_ROS_GRAPH_H_
