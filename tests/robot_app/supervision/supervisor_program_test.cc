// The program coppice-supervisor, with a real master and real processes.
#include <coppice_msgs/ProcessStates.h>
#include <coppice_msgs/RestartProcess.h>
#include <coppice_msgs/SetConfiguration.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/robot_app/supervision/ros_graph.h"

namespace coppice::robot {
namespace {

using coppice_msgs::ProcessState;
using testing::HasSubstr;

constexpr char kConfig[] = R"(
stop_timeout: 1
parameters: {answer: 42, use_sim_time: false}
processes:
  - {name: first, command: ["${talker}", "__name:=first"], node: /first, ready: topic /talk}
  - {name: second, command: ["${talker}", "__name:=second"], node: /second, depends: [first]}
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
    std::ofstream(folder_ + "/robot.yaml") << kConfig;
  }

  std::vector<std::string> Command() const {
    return {kPrograms + "coppice-supervisor",
            "--config",
            folder_ + "/robot.yaml",
            "--port",
            "0",
            "--port-file",
            folder_ + "/port",
            "--logs",
            folder_ + "/logs",
            "--set",
            "talker=" + kTestPrograms + "test_talker"};
  }

  void StartSupervisor() {
    supervisor_ = graph_.Start("supervisor", Command());
    int port = 0;
    const auto port_is_known = [&] {
      return static_cast<bool>(std::ifstream(folder_ + "/port") >> port);
    };
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(20);
    while (!port_is_known() && ros::WallTime::now() < deadline) ros::WallDuration(0.01).sleep();
    ASSERT_NE(port, 0);
    graph_.Join("http://127.0.0.1:" + std::to_string(port));
    subscriber_ = graph_.node().subscribe<coppice_msgs::ProcessStates>(
        "/processes", 50, [this](const coppice_msgs::ProcessStates::ConstPtr& message) {
          configuration_ = message->configuration;
          for (const ProcessState& state : message->processes) states_[state.name] = state;
        });
    ASSERT_TRUE(WaitForState("second", ProcessState::READY));
    ASSERT_TRUE(WaitForState("stubborn", ProcessState::READY));
  }

  bool WaitForState(const std::string& name, int state) {
    return graph_.WaitFor([&] { return states_.count(name) && states_[name].state == state; }, 15);
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
  ros::Subscriber subscriber_;
  std::string configuration_;
  std::map<std::string, ProcessState> states_;
};

TEST_F(SupervisorProgramTest, RestartsOnRequestOnlyAndLeavesNothingBehind) {
  StartSupervisor();
  double answer = 0;
  EXPECT_TRUE(ros::param::get("/answer", answer));
  EXPECT_EQ(answer, 42);

  const int killed = states_["second"].pid;
  kill(killed, SIGKILL);
  ASSERT_TRUE(WaitForState("second", ProcessState::STOPPED));
  EXPECT_EQ(states_["second"].message, "ended by signal 9");
  EXPECT_EQ(states_["first"].state, ProcessState::READY);

  EXPECT_TRUE(Restart("/second").ok);
  ASSERT_TRUE(graph_.WaitFor([&] { return states_["second"].pid > 0; }, 5));
  ASSERT_TRUE(WaitForState("second", ProcessState::READY));
  EXPECT_NE(states_["second"].pid, killed);
  EXPECT_EQ(states_["second"].restarts, 1u);
  EXPECT_THAT(Restart("secnd").message, HasSubstr("did you mean \"second\"?"));

  // A hung process is no reason not to restart it.
  const int hung = states_["first"].pid;
  kill(hung, SIGSTOP);
  EXPECT_TRUE(Restart("first").ok);
  ASSERT_TRUE(
      graph_.WaitFor([&] { return states_["first"].pid > 0 && states_["first"].pid != hung; }, 10));
  ASSERT_TRUE(WaitForState("first", ProcessState::READY));

  // One that ignores SIGTERM is killed; all of its group is gone.
  coppice_msgs::SetConfiguration charging;
  charging.request.configuration = "charging";
  ASSERT_TRUE(ros::service::call("/supervisor/set_configuration", charging));
  EXPECT_TRUE(charging.response.ok);
  const int stubborn = states_["stubborn"].pid;
  ASSERT_TRUE(graph_.WaitFor([&] { return states_["stubborn"].pid == 0; }, 5));
  EXPECT_EQ(configuration_, "charging");
  EXPECT_TRUE(graph_.WaitFor([&] { return kill(-stubborn, 0) != 0; }, 5));
  ASSERT_TRUE(graph_.WaitFor([&] { return states_["second"].pid == 0; }, 5));

  const int first = states_["first"].pid;
  ASSERT_GT(first, 0);
  subscriber_.shutdown();
  const int wait_status = graph_.Kill(supervisor_, SIGTERM);
  EXPECT_TRUE(WIFEXITED(wait_status) && WEXITSTATUS(wait_status) == 0) << wait_status;
  EXPECT_NE(kill(first, 0), 0);
  EXPECT_FALSE(MasterAnswers(*ParseUri(ros::master::getURI()), std::chrono::seconds(1)));
}

TEST_F(SupervisorProgramTest, ReportsBadInputInOneLineEachWithStatus2) {
  const auto run = [this](std::vector<std::string> command, const std::string& name) {
    int status = 0;
    waitpid(graph_.Start(name, std::move(command)), &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 2);
    std::ostringstream text;
    text << std::ifstream(folder_ + "/" + name + ".log").rdbuf();
    return text.str();
  };
  const std::string program = kPrograms + "coppice-supervisor";
  EXPECT_THAT(run({program}, "usage"), HasSubstr("usage: coppice-supervisor --config FILE"));
  EXPECT_THAT(run({program, "--config", "/nowhere"}, "missing"),
              HasSubstr("/nowhere: error: cannot read the file"));
  EXPECT_THAT(run({program, "--config", folder_ + "/robot.yaml"}, "variable"),
              HasSubstr("robot.yaml:5:"));
  EXPECT_THAT(run({program, "--set", "x"}, "set"), HasSubstr("--set needs NAME=VALUE"));
}

}  // namespace
}  // namespace coppice::robot
