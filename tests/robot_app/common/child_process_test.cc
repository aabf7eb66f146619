#include "robot_app/common/child_process.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace coppice::robot {
namespace {

using std::chrono::seconds;

std::string Contents(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void WaitForEnd(ChildProcess& child) {
  while (child.IsRunning()) std::this_thread::yield();
}

class ChildProcessTest : public testing::Test {
 protected:
  const std::string log_ = testing::TempDir() + "child_process_test.log";
  ~ChildProcessTest() override { std::remove(log_.c_str()); }
};

TEST_F(ChildProcessTest, GivesTheExitStatus) {
  ChildProcess child({"sh", "-c", "exit 7"}, log_);
  WaitForEnd(child);
  EXPECT_EQ(child.exit_status(), 7);
}

TEST_F(ChildProcessTest, WritesItsOutputToTheLog) {
  ChildProcess child({"sh", "-c", "echo out; echo error >&2"}, log_);
  WaitForEnd(child);
  EXPECT_EQ(Contents(log_), "out\nerror\n");
}

TEST_F(ChildProcessTest, PassesTheEnvironmentOn) {
  ChildProcess child({"sh", "-c", "echo $COPPICE_TEST"}, log_, {{"COPPICE_TEST", "leaf"}});
  WaitForEnd(child);
  EXPECT_EQ(Contents(log_), "leaf\n");
}

TEST_F(ChildProcessTest, ThrowsForAProgramThatDoesNotExist) {
  EXPECT_THROW(ChildProcess({"/no/such/program"}, log_), std::runtime_error);
}

TEST_F(ChildProcessTest, StopsAProgramThatListens) {
  ChildProcess child({"sleep", "100"}, log_);
  EXPECT_EQ(child.Stop(seconds(5)), 128 + SIGTERM);
  EXPECT_FALSE(ProcessExists(child.pid()));
}

TEST_F(ChildProcessTest, KillsAProgramThatDoesNotListen) {
  ChildProcess child({"sh", "-c", "trap '' TERM; echo ready; while :; do sleep 1; done"}, log_);
  while (Contents(log_).empty()) std::this_thread::yield();
  EXPECT_EQ(child.Stop(std::chrono::milliseconds(50)), 128 + SIGKILL);
}

TEST_F(ChildProcessTest, TakesItsChildrenWithIt) {
  ChildProcess child({"sh", "-c", "sleep 100 & echo $!; wait"}, log_);
  while (Contents(log_).empty()) std::this_thread::yield();
  const pid_t grandchild = std::stoi(Contents(log_));
  EXPECT_TRUE(ProcessExists(grandchild));
  child.Stop(seconds(5));
  const auto deadline = std::chrono::steady_clock::now() + seconds(5);
  while (ProcessExists(grandchild) && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::yield();
  }
  EXPECT_FALSE(ProcessExists(grandchild));
}

}  // namespace
}  // namespace coppice::robot
