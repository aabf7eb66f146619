// The program coppice-supervisor with a configuration of three programs, a real master and real
// processes, for a test.
#ifndef COPPICE_TESTS_ROBOT_APP_PROCESSES_SUPERVISOR_PROGRAM_FIXTURE_H_
#define COPPICE_TESTS_ROBOT_APP_PROCESSES_SUPERVISOR_PROGRAM_FIXTURE_H_

#include <coppice_msgs/ProcessStates.h>
#include <coppice_msgs/RestartProcess.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "robot_app/processes/launch/survivors.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/processes/ros_graph.h"

namespace coppice::robot::processes {

inline constexpr char kConfig[] = R"(
stop_timeout: 1
parameters: {answer: 42, use_sim_time: false}
processes:
  - {name: first, command: ["${talker}", "__name:=first"], node: /first, ready: topic /talk}
  - {name: second, command: ["${talker}", "__name:=second"], node: /second, depends: [first],
     ready: service /second/get_loggers}
  - {name: stubborn, command: [/bin/sh, -c, "trap '' TERM; while true; do sleep 1000; done"]}
configurations:
  operating: [first, second, stubborn]
  charging: [first]
)";

class SupervisorProgramTest : public testing::Test {
 protected:
  SupervisorProgramTest() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    WriteConfig(kConfig);
  }

  void WriteConfig(const std::string& text) const {
    std::ofstream(folder_ + "/robot.yaml") << text;
  }

  std::vector<std::string> Command() const {
    return {kPrograms + "coppice-supervisor",
            "--config",
            folder_ + "/robot.yaml",
            "--port",
            std::to_string(RosGraph::OwnPort()),
            "--port-file",
            folder_ + "/port",
            "--logs",
            folder_ + "/logs",
            "--set",
            "talker=" + kTestPrograms + "test_talker",
            "--set",
            "folder=" + folder_};
  }

  void StartSupervisor(const std::vector<std::string>& more = {}) {
    std::vector<std::string> command = Command();
    command.insert(command.end(), more.begin(), more.end());
    std::filesystem::remove(folder_ + "/port");
    supervisor_ = graph_.Start("supervisor", command);
    ASSERT_TRUE(
        Eventually([&] { return static_cast<bool>(std::ifstream(folder_ + "/port") >> port_); }));
  }

  // -1 if it does not end.
  static int ExitStatusOf(int pid) {
    int status = 0;
    if (!Eventually([&] { return waitpid(pid, &status, WNOHANG) == pid; })) return -1;
    return WEXITSTATUS(status);
  }

  // What a command that must end with status 2 says; `name`: of its log.
  std::string Refusal(std::vector<std::string> command, const std::string& name) {
    EXPECT_EQ(ExitStatusOf(graph_.Start(name, std::move(command))), 2);
    return Read(name + ".log");
  }

  // Of a program of the supervisor; 0 if there is none, -1 if there are several.
  int PidOf(const std::string& process) const {
    const auto pids = FindOwned(folder_ + "/logs/supervisor.json:" + process);
    return pids.empty() ? 0 : pids.size() > 1 ? -1 : pids[0];
  }

  // What a node says about itself when it is asked over the network; 0 while it does not answer.
  int PidOfNode(const std::string& node) const {
    NodeProbe probe({"127.0.0.1", port_}, "/test");
    probe.Begin({{node, ""}}, std::chrono::seconds(1));
    probe.Work(std::chrono::seconds(2));
    return probe.results()[0].answered ? probe.results()[0].pid : 0;
  }

  std::string Read(const std::string& file) const {
    std::ostringstream text;
    text << std::ifstream(folder_ + "/" + file).rdbuf();
    return text.str();
  }

  void JoinGraph() {
    graph_.Join("http://127.0.0.1:" + std::to_string(port_));
    subscriber_ = graph_.node().subscribe<coppice_msgs::ProcessStates>(
        "/processes", 50, [this](const coppice_msgs::ProcessStates::ConstPtr& message) {
          configuration_ = message->configuration;
          for (const coppice_msgs::ProcessState& state : message->processes)
            states_[state.name] = state;
        });
    ASSERT_TRUE(WaitForState("second", coppice_msgs::ProcessState::READY));
    ASSERT_TRUE(WaitForState("stubborn", coppice_msgs::ProcessState::READY));
  }

  bool WaitForState(const std::string& name, int state) {
    return graph_.WaitFor([&] { return states_.count(name) && states_[name].state == state; });
  }

  coppice_msgs::RestartProcess::Response Restart(const std::string& name) {
    coppice_msgs::RestartProcess service;
    service.request.name = name;
    EXPECT_TRUE(ros::service::call("/supervisor/restart", service));
    return service.response;
  }

  const std::string folder_ = Temporary("supervisor_program_test");
  RosGraph graph_{RosGraph::WithoutMaster{}, folder_};
  int supervisor_ = 0;
  int port_ = 0;
  ros::Subscriber subscriber_;
  std::string configuration_;
  std::map<std::string, coppice_msgs::ProcessState> states_;
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_TESTS_ROBOT_APP_PROCESSES_SUPERVISOR_PROGRAM_FIXTURE_H_
