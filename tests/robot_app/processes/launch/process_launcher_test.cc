#include "robot_app/processes/launch/process_launcher.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "robot_app/processes/launch/survivors.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/processes/temporary.h"
#include "tests/robot_app/text_of.h"

namespace coppice::robot::processes {
namespace {

using testing::HasSubstr;

class PosixLauncherTest : public testing::Test {
 protected:
  PosixLauncherTest() {
    std::filesystem::remove_all(folder_);
    launcher_ = std::make_unique<PosixLauncher>(folder_);
  }

  int Start(std::vector<std::string> command, const std::string& name = "child") {
    ProcessConfig config;
    config.name = name;
    config.command = std::move(command);
    config.log = "child.log";
    const Expected<int> pid = launcher_->Start(config);
    error_ = pid.problem();
    return pid ? *pid : 0;
  }
  int Shell(const std::string& script) { return Start({"/bin/sh", "-c", script}); }

  std::string Log() const {
    std::ostringstream text;
    text << std::ifstream(folder_ + "/child.log").rdbuf();
    return text.str();
  }

  // The wait status of a child when it has ended.
  int WaitForEnd(int pid) {
    int status = -1;
    EXPECT_TRUE(Eventually([&] {
      launcher_->Reap([&](int ended, int wait_status) {
        if (ended == pid) status = wait_status;
      });
      return status != -1;
    }));
    return status;
  }

  const std::string folder_ = Temporary("process_launcher_test");
  std::unique_ptr<PosixLauncher> launcher_;
  std::string error_;
};

// What programs print may be secret, as the link with which a person logs in to the page.
TEST_F(PosixLauncherTest, ALogIsReadByItsOwnerAloneAlsoOneThatWasThereBefore) {
  using std::filesystem::perms;
  const std::string log = folder_ + "/child.log";
  std::filesystem::create_directories(folder_);
  std::ofstream(log) << "before\n";
  std::filesystem::permissions(log, perms::owner_all | perms::group_read | perms::others_read);
  WaitForEnd(Shell("echo link"));
  EXPECT_EQ(std::filesystem::status(log).permissions(), perms::owner_read | perms::owner_write);
  EXPECT_THAT(Log(), HasSubstr("before\nlink"));
}

TEST_F(PosixLauncherTest, WritesWhatAProcessSaysIntoItsLog) {
  WaitForEnd(Shell("echo hello; echo trouble >&2; exit 3"));
  const int status = WaitForEnd(Shell("exit 3"));
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_EQ(Log(), "hello\ntrouble\n");
}

TEST_F(PosixLauncherTest, SaysWhyAProgramCannotRun) {
  EXPECT_EQ(Start({"/nowhere/program"}), 0);
  EXPECT_EQ(error_, "cannot run /nowhere/program: No such file or directory");
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);  // no zombie is left
}

// A disk that is full or cannot be written must not end the robot.
TEST_F(PosixLauncherTest, StartsAProgramWhoseLogCannotBeWrittenAndSaysSo) {
  launcher_ = std::make_unique<PosixLauncher>("/proc/nowhere");
  testing::internal::CaptureStderr();
  const int pid = Shell("exit 3");
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("cannot write /proc/nowhere/child.log"));
  ASSERT_GT(pid, 0) << error_;
  EXPECT_EQ(WEXITSTATUS(WaitForEnd(pid)), 3);
}

TEST_F(PosixLauncherTest, WritesThroughNoLinkThatSomebodyHasPutInThePlaceOfALog) {
  const std::string other = folder_ + "/other", log = folder_ + "/child.log";
  std::ofstream(other) << "whole";
  std::filesystem::permissions(other, std::filesystem::perms(0644));
  for (const bool is_hard : {false, true}) {
    if (is_hard) {
      std::filesystem::create_hard_link(other, log);
    } else {
      std::filesystem::create_symlink(other, log);
    }
    WaitForEnd(Shell("echo through"));
    EXPECT_EQ(TextOf(other), "whole");
    EXPECT_EQ(std::filesystem::status(other).permissions(), std::filesystem::perms(0644));
    std::filesystem::remove(log);
  }
  ASSERT_EQ(mkfifo(log.c_str(), 0600), 0);
  WaitForEnd(Shell("true"));  // nobody waits for one who reads it
}

TEST_F(PosixLauncherTest, ALogThatHasGrownTooLongBeginsAnewAndItsEndIsKept) {
  const auto most = std::to_string(PosixLauncher::kMostLogBytes);
  WaitForEnd(Shell("echo oldest; yes | head -c " + most + "; echo newest"));
  launcher_->KeepLogsShort();
  EXPECT_EQ(Log(), "");
  const std::string kept = folder_ + "/child.log.1";
  EXPECT_EQ(std::filesystem::file_size(kept), PosixLauncher::kMostLogBytes);
  EXPECT_EQ(std::filesystem::status(kept).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  const std::string text = TextOf(kept);
  EXPECT_EQ(text.substr(text.size() - 7), "newest\n");
}

TEST_F(PosixLauncherTest, AProgramThatRunsGoesOnAtTheBeginningOfItsNewLog) {
  const auto most = std::to_string(PosixLauncher::kMostLogBytes + 1);
  ASSERT_EQ(mkfifo((folder_ + "/go").c_str(), 0600), 0);
  const int pid = Shell("yes | head -c " + most + "; echo; echo before; read line < " + folder_ +
                        "/go; echo after");
  ASSERT_TRUE(Eventually([&] { return Log().find("before\n") != std::string::npos; }));
  launcher_->KeepLogsShort();
  std::ofstream(folder_ + "/go") << "\n";
  WaitForEnd(pid);
  EXPECT_EQ(Log(), "after\n");
}

TEST_F(PosixLauncherTest, EachProcessLeadsItsOwnGroup) {
  const int pid = Start({"/usr/bin/sleep", "1000"});
  EXPECT_EQ(getpgid(pid), pid);
  launcher_->Signal(pid, SIGTERM);
  EXPECT_EQ(WTERMSIG(WaitForEnd(pid)), SIGTERM);
}

TEST_F(PosixLauncherTest, ASignalReachesTheWholeGroup) {
  const int pid = Shell("sleep 1000 & echo $!; wait");
  ASSERT_TRUE(Eventually([&] { return !Log().empty(); }));
  const int grandchild = std::stoi(Log());
  launcher_->Signal(pid, SIGKILL);
  WaitForEnd(pid);
  EXPECT_TRUE(Eventually([&] { return kill(grandchild, 0) != 0; }));
}

TEST_F(PosixLauncherTest, WhatIsLeftOfAGroupIsKilledWhenItsLeaderEnds) {
  const int pid = Shell("sleep 1000 & echo $!; exit 0");
  WaitForEnd(pid);
  const int grandchild = std::stoi(Log());
  EXPECT_TRUE(Eventually([&] { return kill(grandchild, 0) != 0; }));
}

TEST_F(PosixLauncherTest, WhatHasLeftTheGroupIsKilledTooAndOthersOfTheOwnerLiveOn) {
  launcher_ = std::make_unique<PosixLauncher>(folder_, folder_ + "/owner");
  const int other = Start({"/usr/bin/sleep", "1000"}, "child_monitor");
  const int pid = Shell("setsid sleep 1000 & echo $!; exit 0");
  ASSERT_TRUE(Eventually([&] { return !Log().empty(); }));
  WaitForEnd(pid);
  EXPECT_TRUE(Eventually([&] { return FindOwned(folder_ + "/owner").size() == 1; }));
  EXPECT_EQ(kill(other, 0), 0);
  launcher_->Signal(other, SIGKILL);
  WaitForEnd(other);
}

TEST_F(PosixLauncherTest, DeletesTheStateOfAProcess) {
  ProcessConfig config;
  config.state = {folder_ + "/state/file", folder_ + "/state/folder", folder_ + "/none"};
  std::filesystem::create_directories(folder_ + "/state/folder/deeper");
  std::ofstream(folder_ + "/state/file") << "x";
  EXPECT_EQ(launcher_->ClearState(config).problem(), "");
  EXPECT_TRUE(std::filesystem::is_empty(folder_ + "/state"));
}

TEST_F(PosixLauncherTest, AStoppedProcessEndsOnRequest) {
  const int pid = Start({"/usr/bin/sleep", "1000"});
  kill(pid, SIGSTOP);
  launcher_->Signal(pid, SIGTERM);
  EXPECT_EQ(WTERMSIG(WaitForEnd(pid)), SIGTERM);
}

TEST_F(PosixLauncherTest, AProcessInheritsNoOpenFileAndNoBlockedSignal) {
  const int file = open("/dev/zero", O_RDONLY);
  sigset_t blocked, before;
  sigfillset(&blocked);
  sigprocmask(SIG_BLOCK, &blocked, &before);
  const int pid = Shell("ls /proc/self/fd | tr '\\n' ' '; grep SigBlk /proc/self/status");
  sigprocmask(SIG_SETMASK, &before, nullptr);
  WaitForEnd(pid);
  close(file);
  EXPECT_THAT(Log(), testing::StartsWith("0 1 2 3 "));  // 3 is the folder that ls reads
  EXPECT_THAT(Log(), HasSubstr("0000000000000000"));
}

TEST_F(PosixLauncherTest, AChildGetsSigtermWhenItsParentDies) {
  const pid_t parent = fork();
  if (parent == 0) {
    const int pid = Shell("echo $$; exec sleep 1000");
    while (kill(pid, 0) == 0) pause();
    _exit(0);
  }
  ASSERT_TRUE(Eventually([&] { return !Log().empty(); }));
  const int orphan = std::stoi(Log());
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  EXPECT_TRUE(Eventually([&] {
    // Ended: gone, or a zombie if nobody collects orphans here.
    std::ifstream stat("/proc/" + std::to_string(orphan) + "/stat");
    std::string pid, name, state;
    return !(stat >> pid >> name >> state) || state == "Z";
  }));
}

}  // namespace
}  // namespace coppice::robot::processes
