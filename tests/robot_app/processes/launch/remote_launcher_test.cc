// RemoteLauncher with coppice-remote, on another host in all respects that matter here.
#include "robot_app/processes/launch/remote_launcher.h"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "robot_app/processes/launch/survivors.h"
#include "tests/robot_app/processes/other_host.h"
#include "tests/robot_app/processes/temporary.h"

namespace coppice::robot::processes {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class RemoteLauncherTest : public testing::Test {
 protected:
  RemoteLauncherTest() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~RemoteLauncherTest() override { KillOwned(owner_, std::chrono::seconds(5)); }

  int Start(const std::string& script, const std::string& name = "child") {
    ProcessConfig config;
    config.name = name;
    config.command = {"/bin/sh", "-c", script};
    config.log = name + ".log";
    config.host = 0;
    return launcher_->Start(config).value();
  }

  // Keeps everything going until it is true.
  bool Eventually(const std::function<bool()>& condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!condition()) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      Round();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
  }

  void Round() {
    local_.Reap([this](int pid, int status) {
      ended_[pid] = status;
      if (launcher_) launcher_->Forget(pid);
    });
    if (launcher_ && alive_)
      launcher_->KeepAlive(Time(std::chrono::steady_clock::now().time_since_epoch()));
  }

  bool HasEnded(int pid) {
    return Eventually([this, pid] { return ended_.count(pid) > 0; });
  }

  // On the other host.
  std::vector<int> There(const std::string& name = "child") const {
    return FindOwned(OwnedName(owner_ + "@other", name));
  }

  std::string Log(const std::string& name = "child") const {
    std::ostringstream text;
    text << std::ifstream(folder_ + "/" + name + ".log").rdbuf();
    return text.str();
  }

  std::unique_ptr<RemoteLauncher> Make(const HostConfig& host) {
    return std::make_unique<RemoteLauncher>(
        local_, std::vector<HostConfig>{host},
        RemoteSettings{owner_, "http://" + host_.here() + ":1", std::chrono::milliseconds(300)});
  }

  const std::string folder_ = Temporary("remote_launcher_test");
  const std::string owner_ = folder_ + "/owner";
  OtherHost host_;
  PosixLauncher local_{folder_};
  std::unique_ptr<RemoteLauncher> launcher_ = Make(host_.Config());
  std::map<int, int> ended_;
  bool alive_ = true;
};

TEST_F(RemoteLauncherTest, RunsAProcessThereWithItsEnvironmentAndItsLogHere) {
  const int pid = Start("echo $ROS_MASTER_URI $ROS_IP; readlink /proc/self/ns/net; exit 7");
  ASSERT_TRUE(HasEnded(pid));
  EXPECT_EQ(WEXITSTATUS(ended_[pid]), 7);
  EXPECT_THAT(Log(), HasSubstr("coppice-remote: started child\n"));
  EXPECT_THAT(Log(), HasSubstr("http://" + host_.here() + ":1 " + host_.there() + "\n"));
  const std::string network = std::filesystem::read_symlink("/proc/self/ns/net");
  if (host_.is_namespace()) {
    EXPECT_THAT(Log(), testing::Not(HasSubstr(network)));
  }
}

TEST_F(RemoteLauncherTest, IsConnectedWhenTheProcessWasStartedThere) {
  const int pid = Start("exec sleep 1000");
  EXPECT_TRUE(Eventually([&] { return launcher_->IsConnected(pid); }));
  launcher_->Signal(pid, SIGTERM);
  ASSERT_TRUE(HasEnded(pid));
  EXPECT_EQ(WEXITSTATUS(ended_[pid]), 128 + SIGTERM);
  EXPECT_THAT(There(), IsEmpty());
}

TEST_F(RemoteLauncherTest, KillsAWholeGroupThatIgnoresSigtermOrIsStopped) {
  const int pid = Start("trap '' TERM; sleep 1000 & while true; do sleep 1000; done");
  ASSERT_TRUE(Eventually([&] { return There().size() >= 3; }));
  launcher_->Signal(pid, SIGTERM);
  for (const int there : There()) kill(there, SIGSTOP);
  launcher_->Signal(pid, SIGKILL);
  EXPECT_TRUE(HasEnded(pid));
  EXPECT_TRUE(Eventually([&] { return There().empty(); }));
}

TEST_F(RemoteLauncherTest, WhatRunsThereEndsWhenTheConnectionBreaks) {
  const int pid = Start("exec sleep 1000");
  ASSERT_TRUE(Eventually([&] { return launcher_->IsConnected(pid) && There().size() == 1; }));
  launcher_.reset();  // as if the supervisor had died
  EXPECT_TRUE(Eventually([&] {
    local_.Reap([](int, int) {});
    return There().empty();
  }));
}

TEST_F(RemoteLauncherTest, WhatRunsThereEndsWhenTheSupervisorSaysNothingAnyMore) {
  const int pid = Start("exec sleep 1000");
  ASSERT_TRUE(Eventually([&] { return There().size() == 1; }));
  alive_ = false;  // the connection is there, but nothing comes over it
  EXPECT_TRUE(Eventually([&] { return There().empty(); }));
  EXPECT_TRUE(HasEnded(pid));
}

TEST_F(RemoteLauncherTest, NeverRunsTwoInstancesEvenIfAnOldOneWasForgotten) {
  const int first = Start("exec sleep 1000");
  ASSERT_TRUE(Eventually([&] { return launcher_->IsConnected(first) && There().size() == 1; }));
  const int old = There().front();
  const int other = Start("exec sleep 1000", "child_monitor");
  const int pid = Start("exec sleep 1000");
  ASSERT_TRUE(Eventually([&] { return launcher_->IsConnected(pid) && There().size() == 1; }));
  EXPECT_NE(There().front(), old);
  EXPECT_TRUE(Eventually([&] { return There("child_monitor").size() == 1; }));
  EXPECT_EQ(ended_.count(other), 0u);
}

TEST_F(RemoteLauncherTest, AHostThatCannotBeReachedIsNotAProgramThatFails) {
  HostConfig host = host_.Config();
  host.command = {"/bin/sh", "-c", "echo no route to host; exit 255", "sh"};
  launcher_ = Make(host);
  const int pid = Start("true");
  EXPECT_FALSE(launcher_->IsConnected(pid));
  ASSERT_TRUE(HasEnded(pid));
  EXPECT_EQ(WEXITSTATUS(ended_[pid]), 255);
}

TEST_F(RemoteLauncherTest, AStatusOf255IsNotTakenForALostConnection) {
  const int pid = Start("exit 255");
  ASSERT_TRUE(HasEnded(pid));
  EXPECT_EQ(WEXITSTATUS(ended_[pid]), 254);
}

TEST_F(RemoteLauncherTest, AProgramThatIsNotThereIsReportedInTheLog) {
  ProcessConfig config;
  config.name = "child";
  config.command = {"/nowhere/program"};
  config.log = "child.log";
  config.host = 0;
  const int pid = launcher_->Start(config).value();
  ASSERT_TRUE(HasEnded(pid));
  EXPECT_EQ(WEXITSTATUS(ended_[pid]), 127);
  EXPECT_THAT(Log(), HasSubstr("cannot run /nowhere/program"));
}

TEST_F(RemoteLauncherTest, ATransportThatHangsIsKilled) {
  HostConfig host = host_.Config();
  host.command = {"/bin/sh", "-c", "sleep 1000", "sh"};
  launcher_ = Make(host);
  const int pid = Start("true");
  launcher_->Signal(pid, SIGTERM);
  launcher_->Signal(pid, SIGKILL);
  EXPECT_TRUE(HasEnded(pid));
}

TEST(RemoteCommandTest, WordsAreQuotedForAShellThere) {
  HostConfig host;
  host.name = "jetson";
  host.command = {"ssh", "user@jetson", "--"};
  host.bin = "/opt/coppice";
  ProcessConfig process;
  process.name = "camera";
  process.command = {"/opt/camera", "it's $HOME"};
  const RemoteSettings settings{"/state", "http://10.0.0.1:11311", std::chrono::seconds(3)};
  EXPECT_THAT(
      RemoteCommand(host, process, settings),
      ElementsAre("ssh", "user@jetson", "--", "'/opt/coppice/coppice-remote'", "'--owner'",
                  "'/state@jetson'", "'--name'", "'camera'", "'--stop-timeout'", "'3000'",
                  "'--silence'", "'10000'", "'--env'", "'ROS_MASTER_URI=http://10.0.0.1:11311'",
                  "'--'", "'/opt/camera'", "'it'\\''s $HOME'"));
}

}  // namespace
}  // namespace coppice::robot::processes
