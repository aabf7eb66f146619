// The program coppice-supervisor, with a real master and real processes.
#include <coppice_msgs/SetConfiguration.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <xmlrpcpp/XmlRpcServer.h>
#include <xmlrpcpp/XmlRpcServerMethod.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "tests/robot_app/processes/other_host.h"
#include "tests/robot_app/processes/shut_down_node.h"
#include "tests/robot_app/processes/supervisor_program_fixture.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::processes {
namespace {

using coppice_msgs::ProcessState;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

TEST_F(SupervisorProgramTest, RestartsWhatEndsOrIsAskedForAndLeavesNothingBehind) {
  StartSupervisor();
  JoinGraph();
  double answer = 0;
  EXPECT_TRUE(ros::param::get("/answer", answer));
  EXPECT_EQ(answer, 42);
  EXPECT_EQ(states_["second"].group, "second");
  EXPECT_EQ(states_["second"].restarts_allowed, 3u);

  const int crashed = states_["second"].pid;
  const ros::WallTime death = ros::WallTime::now();
  kill(crashed, SIGKILL);
  ASSERT_TRUE(graph_.WaitFor([&] { return states_["second"].state != ProcessState::READY; }));
  EXPECT_EQ(states_["second"].restarts_in_window, 1u);
  EXPECT_EQ(states_["first"].state, ProcessState::READY);
  ASSERT_TRUE(WaitForState("second", ProcessState::READY));
  RecordProperty("ms_from_death_to_ready",
                 static_cast<int>((ros::WallTime::now() - death).toSec() * 1000));
  EXPECT_NE(states_["second"].pid, crashed);

  const int killed = states_["second"].pid;
  EXPECT_TRUE(Restart("/second").ok);
  ASSERT_TRUE(
      graph_.WaitFor([&] { return states_["second"].pid > 0 && states_["second"].pid != killed; }));
  ASSERT_TRUE(WaitForState("second", ProcessState::READY));
  EXPECT_EQ(states_["second"].restarts, 2u);
  EXPECT_THAT(Restart("secnd").message, HasSubstr("did you mean \"second\"?"));

  // A hung process is no reason not to restart it.
  const int hung = states_["first"].pid;
  kill(hung, SIGSTOP);
  EXPECT_TRUE(Restart("first").ok);
  ASSERT_TRUE(
      graph_.WaitFor([&] { return states_["first"].pid > 0 && states_["first"].pid != hung; }));
  ASSERT_TRUE(WaitForState("first", ProcessState::READY));

  // One that ignores SIGTERM is killed; all of its group is gone.
  coppice_msgs::SetConfiguration charging;
  charging.request.configuration = "charging";
  ASSERT_TRUE(ros::service::call("/supervisor/set_configuration", charging));
  EXPECT_TRUE(charging.response.ok);
  const int stubborn = states_["stubborn"].pid;
  ASSERT_TRUE(graph_.WaitFor([&] { return states_["stubborn"].pid == 0; }));
  EXPECT_EQ(configuration_, "charging");
  EXPECT_TRUE(graph_.WaitFor([&] { return kill(-stubborn, 0) != 0; }));
  ASSERT_TRUE(graph_.WaitFor([&] { return states_["second"].pid == 0; }));

  const int first = states_["first"].pid;
  ASSERT_GT(first, 0);
  subscriber_.shutdown();
  const int wait_status = graph_.Kill(supervisor_, SIGTERM);
  EXPECT_TRUE(WIFEXITED(wait_status) && WEXITSTATUS(wait_status) == 0) << wait_status;
  EXPECT_NE(kill(first, 0), 0);
  EXPECT_FALSE(MasterAnswers(*ParseUri(ros::master::getURI()), std::chrono::seconds(1)));
}

TEST_F(SupervisorProgramTest, WhatIsRestartedFindsTheParametersAlthoughSomebodyHasWipedThem) {
  StartSupervisor();
  JoinGraph();
  ASSERT_TRUE(ros::param::del("/answer"));
  const int before = states_["second"].pid;
  ASSERT_TRUE(Restart("second").ok);
  ASSERT_TRUE(
      graph_.WaitFor([&] { return states_["second"].pid > 0 && states_["second"].pid != before; }));
  double answer = 0;
  EXPECT_TRUE(ros::param::get("/answer", answer));
  EXPECT_EQ(answer, 42);
  subscriber_.shutdown();
  graph_.Kill(supervisor_, SIGTERM);
}

TEST_F(SupervisorProgramTest, TheEndOfTheMasterIsTheBeginningOfANewStack) {
  StartSupervisor();
  ASSERT_TRUE(Eventually([&] { return PidOfNode("/second") > 0; }));
  const int master = PidOf("rosmaster"), first = PidOf("first");
  kill(master, SIGKILL);
  ASSERT_TRUE(Eventually([&] {
    return PidOf("rosmaster") > 0 && PidOf("rosmaster") != master && PidOfNode("/second") > 0;
  }));
  EXPECT_GT(PidOf("first"), 0);
  EXPECT_NE(PidOf("first"), first);
  EXPECT_EQ(kill(supervisor_, 0), 0);  // still the same process
  EXPECT_THAT(Read("supervisor.log"), HasSubstr("begins anew: the ROS master ended"));
  graph_.Kill(supervisor_, SIGTERM);
  EXPECT_EQ(PidOf(""), 0);
}

// Nothing could be restarted any more, nor could anybody ask for it.
TEST_F(SupervisorProgramTest, AMasterThatHangsIsEndedAndTheStackBeginsAnew) {
  StartSupervisor();
  ASSERT_TRUE(Eventually([&] { return PidOfNode("/second") > 0; }));
  const int master = PidOf("rosmaster"), first = PidOf("first");
  RosGraph::Hang(master);
  ASSERT_TRUE(Eventually([&] {
    return PidOf("rosmaster") > 0 && PidOf("rosmaster") != master && PidOfNode("/second") > 0;
  }));
  EXPECT_NE(PidOf("first"), first);
  EXPECT_THAT(Read("supervisor.log"), HasSubstr("the ROS master hangs, and is ended"));
  graph_.Kill(supervisor_, SIGTERM);
  EXPECT_EQ(PidOf(""), 0);
}

TEST_F(SupervisorProgramTest, WhenItsNodeIsShutDownFromOutsideTheStackBeginsAnew) {
  StartSupervisor();
  ASSERT_TRUE(Eventually([&] { return PidOfNode("/second") > 0; }));
  const int first = PidOf("first");
  ASSERT_TRUE(ShutDownNode({"127.0.0.1", port_}, "/supervisor"));
  ASSERT_TRUE(Eventually(
      [&] { return PidOf("first") > 0 && PidOf("first") != first && PidOfNode("/second") > 0; }));
  EXPECT_EQ(kill(supervisor_, 0), 0);
  EXPECT_EQ(PidOfNode("/supervisor"), supervisor_);
  EXPECT_THAT(Read("supervisor.log"), HasSubstr("begins anew: the supervisor's ROS node was shut"));
  graph_.Kill(supervisor_, SIGTERM);
  EXPECT_EQ(PidOf(""), 0);
}

// The talker's topic is its heartbeat.
TEST_F(SupervisorProgramTest, AProgramThatIsStoppedIsRestartedWithoutAnybodyAsking) {
  WriteConfig(R"(
stop_timeout: 1
processes:
  - {name: first, command: ["${talker}", "__name:=first"], node: /first,
     heartbeat: {topic: /talk, timeout: 1}}
configurations:
  operating: [first]
)");
  StartSupervisor();
  const auto is_ready = [&] {
    return Read("supervisor.log").find("first: READY") != std::string::npos;
  };
  ASSERT_TRUE(Eventually(is_ready));
  const int first = PidOf("first");
  kill(first, SIGSTOP);
  EXPECT_TRUE(Eventually([&] { return PidOfNode("/first") > 0 && PidOfNode("/first") != first; }));
  EXPECT_THAT(Read("supervisor.log"), HasSubstr("gave no sign of life for 1 s"));
  graph_.Kill(supervisor_, SIGTERM);
}

// A pager that nobody scrolls, a terminal that was stopped, a connection that hangs.
TEST_F(SupervisorProgramTest, WorksThoughNobodyReadsWhatItSays) {
  const std::string pipe = folder_ + "/pipe", block(4096, 'x');
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int full = open(pipe.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  while (write(full, block.data(), block.size()) > 0) continue;
  std::vector<std::string> command = Command();
  command.insert(command.begin(), {"/bin/sh", "-c", "exec \"$0\" \"$@\" > " + pipe + " 2>&1"});
  supervisor_ = graph_.Start("supervisor", command);
  ASSERT_TRUE(
      Eventually([&] { return static_cast<bool>(std::ifstream(folder_ + "/port") >> port_); }));
  ASSERT_TRUE(Eventually([&] { return PidOfNode("/second") > 0; }));
  const int second = PidOf("second");
  kill(second, SIGKILL);
  EXPECT_TRUE(
      Eventually([&] { return PidOfNode("/second") > 0 && PidOfNode("/second") != second; }));
  graph_.Kill(supervisor_, SIGTERM);
  close(full);
}

TEST_F(SupervisorProgramTest, RestartsProgramsThoughTheDiskIsSlow) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer wants to be loaded first";
#endif
  setenv("COPPICE_TEST_DISK_READY", (folder_ + "/ready").c_str(), 1);
  setenv("LD_PRELOAD", (BinaryFolder() + "/tests/lib/libtest_slow_disk.so").c_str(), 1);
  StartSupervisor();
  unsetenv("LD_PRELOAD");
  ASSERT_TRUE(Eventually([&] { return PidOfNode("/second") > 0; }));
  const int second = PidOf("second");
  kill(second, SIGKILL);
  EXPECT_TRUE(
      Eventually([&] { return PidOfNode("/second") > 0 && PidOfNode("/second") != second; }));
  std::ofstream(folder_ + "/ready") << "now\n";
  EXPECT_TRUE(Eventually(
      [&] { return Read("logs/supervisor.json").find("\"second\": 1") != std::string::npos; }));
  graph_.Kill(supervisor_, SIGTERM);
  EXPECT_EQ(PidOf(""), 0);
}

// Where systemd listens to a service: in a folder of its own, for a socket has 107 characters.
class NotifySocket {
 public:
  NotifySocket() {
    const std::string path = folder_.Path("notify");
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof(address.sun_path) - 1);
    if (bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
      ADD_FAILURE() << path << ": " << std::strerror(errno);
    }
    setenv("NOTIFY_SOCKET", path.c_str(), 1);
  }
  ~NotifySocket() {
    unsetenv("NOTIFY_SOCKET");
    close(socket_);
  }

  // The next message; empty if none comes.
  std::string Receive(int ms = 60'000) const {
    pollfd ready{socket_, POLLIN, 0};
    std::string text(4096, '\0');
    if (poll(&ready, 1, ms) != 1) return "";
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, recv(socket_, &text[0], 4096, 0))));
    return text;
  }
  void Drain() const {
    while (!Receive(0).empty()) {
    }
  }

 private:
  const TemporaryFolder folder_;
  const int socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

TEST_F(SupervisorProgramTest, SystemdHearsThatItLivesAndHearsNothingWhenItHangs) {
  const NotifySocket systemd;
  StartSupervisor();
  for (int i = 0; i < 3; ++i) {
    EXPECT_THAT(systemd.Receive(), AllOf(HasSubstr("READY=1"), HasSubstr("WATCHDOG=1")));
  }
  RosGraph::Hang(supervisor_);
  systemd.Drain();
  EXPECT_EQ(systemd.Receive(2500), "");
  kill(supervisor_, SIGCONT);
  EXPECT_THAT(systemd.Receive(), HasSubstr("WATCHDOG=1"));
  graph_.Kill(supervisor_, SIGTERM);
}

TEST_F(SupervisorProgramTest, AKilledSupervisorLeavesNoSecondInstanceAndItsCountersLiveOn) {
  StartSupervisor();
  ASSERT_TRUE(Eventually([&] { return PidOfNode("/second") > 0; }));
  kill(PidOf("second"), SIGKILL);
  ASSERT_TRUE(Eventually(
      [&] { return Read("logs/supervisor.json").find("\"second\": 1") != std::string::npos; }));
  const int stubborn = FindOwned(folder_ + "/logs/supervisor.json:stubborn").front();
  graph_.Kill(supervisor_, SIGKILL);
  ASSERT_TRUE(Eventually([&] { return PidOf("second") == 0 && PidOf("first") == 0; }));
  EXPECT_EQ(kill(stubborn, 0), 0);  // it ignores SIGTERM

  StartSupervisor();
  ASSERT_TRUE(Eventually([&] { return PidOfNode("/second") > 0; }));
  EXPECT_THAT(FindOwned(folder_ + "/logs/supervisor.json:stubborn"), Not(Contains(stubborn)));
  EXPECT_THAT(Read("supervisor.log"), HasSubstr("processes of an earlier supervisor were ended"));
  EXPECT_THAT(Read("logs/supervisor.json"), HasSubstr("\"second\": 1"));
  graph_.Kill(supervisor_, SIGTERM);
  EXPECT_EQ(PidOf(""), 0);
}

TEST_F(SupervisorProgramTest, ASecondStartLeavesTheRunningRobotAlone) {
  StartSupervisor();
  JoinGraph();
  const int second = PidOf("second");
  EXPECT_THAT(Refusal(Command(), "again"), HasSubstr("it runs already"));
  EXPECT_GT(second, 0);
  EXPECT_EQ(PidOf("second"), second);
}

TEST_F(SupervisorProgramTest, ACrashLoopClimbsToThePersonInABoundedNumberOfStarts) {
  WriteConfig(R"(
restart_intensity: {restarts: 2, window: 5, floor: 0.1, healthy_after: 60}
back_off: {first: 0.1, most: 0.2}
on_given_up:
  command: [/bin/sh, -c, 'echo "$0" >> ${folder}/calls']
  configuration: safe
processes:
  - {name: root, command: [/bin/sh, -c, "echo >> ${folder}/starts; sleep 0.3; exit 3"]}
  - {name: dependent, command: [/bin/sleep, 1000], depends: [root]}
  - {name: daemon, command: [/bin/sh, -c, "setsid sleep 1000 & exec sleep 1000"]}
configurations:
  all: [root, dependent, daemon]
  safe: [daemon]
)");
  StartSupervisor();
  ASSERT_TRUE(Eventually([&] { return !Read("calls").empty(); }));
  EXPECT_THAT(Read("calls"),
              HasSubstr("The robot has given up root: root ended with exit status 3"));
  EXPECT_EQ(Read("starts").size(), 5u);  // first, two restarts, closure, stack
  EXPECT_TRUE(Eventually([&] { return PidOf("dependent") == 0 && PidOf("daemon") != 0; }));
  graph_.Kill(supervisor_, SIGTERM);
  EXPECT_EQ(PidOf(""), 0);  // nor is there what has made a session of its own
  EXPECT_EQ(Read("starts").size(), 5u);
}

// A node behind another network, supervised as if it were here.
TEST_F(SupervisorProgramTest, ANodeOnAnotherHostIsStartedRestartedAndEndedLikeOneOfThisHost) {
  const OtherHost host;
  std::string transport;
  for (const std::string& word : host.Transport()) transport += "'" + word + "', ";
  WriteConfig("stop_timeout: 1\nhosts:\n  other:\n    command: [" + transport + "]\n" +
              "    shell: no\n    bin: " + kTestPrograms +
              "../../bin\n    address: " + host.there() + R"(
processes:
  - {name: here, command: ["${talker}", "__name:=here"], node: /here}
  - {name: there, command: ["${talker}", "__name:=there"], node: /there, depends: [here],
     host: other}
configurations: {all: [here, there]}
)");
  StartSupervisor({"--address", host.here()});
  ASSERT_TRUE(Eventually([&] { return PidOfNode("/there") > 0; })) << Read("logs/there.log");
  // 0 if there is none, -1 if there are several.
  const auto instance = [&] {
    const auto pids = FindOwned(OwnedName(folder_ + "/logs/supervisor.json@other", "there"));
    return pids.empty() ? 0 : pids.size() > 1 ? -1 : pids[0];
  };
  ASSERT_TRUE(Eventually([&] { return instance() > 0; }));
  const int first = instance();
  ASSERT_GT(first, 0);
  if (host.is_namespace()) {
    const auto network = [](const std::string& pid) {
      return std::filesystem::read_symlink("/proc/" + pid + "/ns/net").string();
    };
    EXPECT_NE(network(std::to_string(first)), network("self"));
  }
  kill(first, SIGKILL);
  ASSERT_TRUE(Eventually([&] {
    const int second = instance();
    return second > 0 && second != first && PidOfNode("/there") > 0;
  }));
  graph_.Kill(supervisor_, SIGTERM);
  EXPECT_TRUE(Eventually([&] { return instance() == 0; }));
}

TEST_F(SupervisorProgramTest, AHostThatCannotBeReachedDisturbsNothingElse) {
  WriteConfig(R"(
hosts:
  moon: {command: [/bin/sh, -c, "exit 255", sh], bin: /nowhere, shell: no}
processes:
  - {name: here, command: ["${talker}", "__name:=here"], node: /here}
  - {name: there, command: [x], host: moon}
configurations: {all: [here, there]}
)");
  StartSupervisor();
  EXPECT_TRUE(Eventually([&] {
    return Read("supervisor.log").find("there: UNREACHABLE, host moon cannot be reached") !=
           std::string::npos;
  }));
  EXPECT_TRUE(Eventually([&] { return PidOfNode("/here") > 0; }));
  graph_.Kill(supervisor_, SIGTERM);
}

TEST_F(SupervisorProgramTest, TheCommandLineShowsAndAsks) {
  StartSupervisor();
  ASSERT_TRUE(Eventually([&] { return PidOfNode("/second") > 0; }));
  int calls = 0;
  std::string output;
  const auto processes = [&](std::vector<std::string> words) {
    words.insert(words.begin(), kPrograms + "coppice-processes");
    words.insert(words.end(), {"--master", "http://127.0.0.1:" + std::to_string(port_)});
    const std::string name = "call" + std::to_string(++calls);
    const int status = ExitStatusOf(graph_.Start(name, words));
    output = Read(name + ".log");
    return status;
  };
  EXPECT_TRUE(Eventually([&] { return processes({}) == 0; })) << output;
  EXPECT_THAT(output, HasSubstr("configuration operating\nPROCESS "));
  EXPECT_EQ(processes({"--json"}), 0);
  EXPECT_THAT(output, HasSubstr("\"restarts_allowed\": 3"));

  EXPECT_EQ(processes({"configuration", "charging"}), 0);
  EXPECT_EQ(output, "changing to configuration charging\n");
  EXPECT_TRUE(Eventually([&] { return PidOf("second") == 0 && processes({}) == 0; }));
  EXPECT_THAT(output, HasSubstr("configuration charging, held by hand\n"));
  EXPECT_EQ(processes({"release"}), 0);
  EXPECT_EQ(processes({"restart", "firts"}), 1);
  EXPECT_THAT(output, HasSubstr("did you mean \"first\"?"));
  const int first = PidOf("first");
  EXPECT_EQ(processes({"restart", "first"}), 0);
  EXPECT_TRUE(Eventually([&] { return PidOf("first") > 0 && PidOf("first") != first; }));
  EXPECT_EQ(processes({"reset", "all"}), 0);

  EXPECT_EQ(processes({"explode", "first"}), 2);
  EXPECT_EQ(processes({"restart"}), 2);
  EXPECT_EQ(processes({"--wach"}), 2);
  graph_.Kill(supervisor_, SIGTERM);
  EXPECT_EQ(processes({}), 3);
  EXPECT_THAT(output, HasSubstr("no process supervisor answers at http://127.0.0.1:"));
}

TEST_F(SupervisorProgramTest, TheCommandLineWaitsNeitherForAMasterThatHangsNorForOneThatEnds) {
  // Answers one request, then none: as if it had ended.
  XmlRpc::XmlRpcServer master;
  struct Pid : XmlRpc::XmlRpcServerMethod {
    explicit Pid(XmlRpc::XmlRpcServer* server) : XmlRpcServerMethod("getPid", server) {}
    void execute(XmlRpc::XmlRpcValue& /*request*/, XmlRpc::XmlRpcValue& answer) override {
      answer[0] = 1;
      answer[1] = "";
      answer[2] = 1;
      is_asked = true;
    }
    bool is_asked = false;
  } pid(&master);
  ASSERT_TRUE(master.bindAndListen(0));
  const auto ask = [&](const std::string& name) {
    return graph_.Start(name,
                        {kPrograms + "coppice-processes", "release", "--timeout", "0.5", "--master",
                         "http://127.0.0.1:" + std::to_string(master.get_port())});
  };
  // Who only listens is a master that hangs.
  EXPECT_EQ(ExitStatusOf(ask("hangs")), 3) << Read("hangs.log");
  while (!pid.is_asked) master.work(0.1);  // the request that nobody waits for
  pid.is_asked = false;
  const int asker = ask("ends");
  ASSERT_TRUE(Eventually([&] {
    master.work(0.01);
    return pid.is_asked;
  }));
  master.work(0.01);  // the answer leaves
  master.shutdown();
  EXPECT_EQ(ExitStatusOf(asker), 3) << Read("ends.log");
  EXPECT_THAT(Read("ends.log"), HasSubstr("no process supervisor answers at"));
}

TEST_F(SupervisorProgramTest, ReportsBadInputInOneLineEachWithStatus2) {
  const std::string program = kPrograms + "coppice-supervisor";
  EXPECT_THAT(Refusal({program}, "usage"), HasSubstr("--config is required"));
  EXPECT_THAT(Refusal({program, "--config", "/nowhere"}, "missing"),
              HasSubstr("/nowhere: error: cannot be read"));
  EXPECT_THAT(Refusal({program, "--config", folder_ + "/robot.yaml"}, "variable"),
              HasSubstr("robot.yaml:5:"));
  EXPECT_THAT(Refusal({program, "--config", "/nowhere", "--set", "x"}, "set"),
              HasSubstr("--set: expected NAME=VALUE, not \"x\""));
}

// Else a robot whose disk is full would begin anew again and again, and never ask a person.
TEST_F(SupervisorProgramTest, WhatCannotBeWrittenDownIsKnownWhenTheStackBeginsAnew) {
  const std::string memory = folder_ + "/memory";
  std::filesystem::create_directories(memory);
  StartSupervisor({"--state", memory + "/supervisor.json"});
  ASSERT_TRUE(Eventually([&] { return PidOfNode("/first") > 0; }));
  const int before = PidOfNode("/first");
  std::filesystem::remove_all(memory);
  EXPECT_EQ(
      ExitStatusOf(graph_.Start("anew", {kPrograms + "coppice-processes", "restart", "all",
                                         "--master", "http://127.0.0.1:" + std::to_string(port_)})),
      0);
  ASSERT_TRUE(Eventually([&] {
    const int now = PidOfNode("/first");
    return now > 0 && now != before;
  }));
  std::filesystem::create_directories(memory);
  EXPECT_TRUE(Eventually([&] {
    const std::string text = Read("memory/supervisor.json");
    return !text.empty() && text.find("\"stack_restarts\": []") == std::string::npos;
  })) << Read("memory/supervisor.json");
  graph_.Kill(supervisor_, SIGTERM);
}

// A disk that was full for a while.
TEST_F(SupervisorProgramTest, WhatCouldNotBeWrittenDownIsWrittenAsSoonAsItCan) {
  const std::string memory = folder_ + "/memory";
  std::filesystem::create_directories(memory);
  StartSupervisor({"--state", memory + "/supervisor.json"});
  JoinGraph();
  std::filesystem::remove_all(memory);
  EXPECT_EQ(ExitStatusOf(graph_.Start(
                "charge", {kPrograms + "coppice-processes", "configuration", "charging", "--master",
                           "http://127.0.0.1:" + std::to_string(port_)})),
            0);
  ASSERT_TRUE(Eventually(
      [&] { return Read("supervisor.log").find("/supervisor.json") != std::string::npos; }));
  std::filesystem::create_directories(memory);
  EXPECT_TRUE(Eventually(
      [&] { return Read("memory/supervisor.json").find("\"charging\"") != std::string::npos; }));
  graph_.Kill(supervisor_, SIGTERM);
}

}  // namespace
}  // namespace coppice::robot::processes
