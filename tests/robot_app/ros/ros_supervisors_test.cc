#include "robot_app/ros/ros_supervisors.h"

#include <coppice_msgs/AnswerHelp.h>
#include <coppice_msgs/HelpRequests.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "bt_core/testing/leaf_harness.h"
#include "bt_nodes/operators/supervisor_leaves.h"
#include "robot_app/common/child_process.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/support/folders.h"

namespace coppice::robot::adapters {
namespace {

using coppice_msgs::HelpRequest;

constexpr char kConfig[] =
    "channels: [{name: console, kind: console}]\n"
    "supervisors: [{name: Ada, reach: [{channel: console}]}]\n"
    "patience: {settle: 0}\n"
    "page: {port: 0}\n";

class RosSupervisorsTest : public testing::Test {
 protected:
  RosSupervisorsTest() {
    std::ofstream(config_) << kConfig;
    list_subscriber_ = node_.subscribe<coppice_msgs::HelpRequests>(
        "/assistance/requests", 10, [this](const coppice_msgs::HelpRequests::ConstPtr& list) {
          const std::lock_guard<std::mutex> lock(mutex_);
          list_ = *list;
        });
    harness_.Set("subject", std::string("navigation"));
    harness_.Set("question", std::string("stuck"));
  }

  void StartAssistance() {
    assistance_ = ChildProcess(
        {BinaryFolder() + "/bin/coppice-assistance", "--config", config_, "__name:=assistance"},
        testing::TempDir() + "assistance_" + std::to_string(getpid()) + ".log");
  }

  // The newest request in that state; 0 if there is none.
  std::uint32_t InState(std::uint8_t state) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const HelpRequest& request : list_.requests) {
      if (request.state == state) return request.id;
    }
    return 0;
  }

  bool AskAndWait() {
    harness_.Tick();
    return Eventually([&] { return InState(HelpRequest::OPEN) != 0; }, 20);
  }

  static bool Answer(bool fixed) {
    coppice_msgs::AnswerHelp service;
    service.request.by = "Ada";
    service.request.fixed = fixed;
    return ros::service::call("/assistance/answer", service) && service.response.ok;
  }

  const std::string config_ =
      testing::TempDir() + "supervisors_" + std::to_string(getpid()) + ".yaml";
  ros::NodeHandle node_;
  std::mutex mutex_;
  coppice_msgs::HelpRequests list_;
  ros::Subscriber list_subscriber_;  // its callback fills the list until it is gone
  ChildProcess assistance_;
  RosSupervisors supervisors_{node_};
  LeafHarness harness_ =
      LeafHarness::For<leaves::AskSupervisor>(std::ref<leaves::SupervisorChannel>(supervisors_));
};

TEST_F(RosSupervisorsTest, SucceedsWhenAPersonHasConfirmedThatItIsFixed) {
  StartAssistance();
  ASSERT_TRUE(AskAndWait());
  EXPECT_EQ(harness_.Tick(), Status::kRunning);
  EXPECT_TRUE(Answer(true));
  EXPECT_TRUE(Eventually([&] { return harness_.Tick() == Status::kSuccess; }));
}

TEST_F(RosSupervisorsTest, FailsWhenNobodyCouldFixIt) {
  StartAssistance();
  ASSERT_TRUE(AskAndWait());
  EXPECT_TRUE(Answer(false));
  EXPECT_TRUE(Eventually([&] { return harness_.Tick() == Status::kFailure; }));
  EXPECT_EQ(harness_.message(), "Nobody who was asked could fix it.");
}

TEST_F(RosSupervisorsTest, AHaltWithdrawsTheRequest) {
  StartAssistance();
  ASSERT_TRUE(AskAndWait());
  harness_.Halt();
  EXPECT_TRUE(Eventually([&] { return InState(HelpRequest::WITHDRAWN) != 0; }));
}

TEST_F(RosSupervisorsTest, WhileTheNodeIsDownNothingBlocksAndTheQuestionIsKept) {
  harness_.Tick();
  supervisors_.Tell("disk", "The disk is nearly full.");
  EXPECT_EQ(harness_.Tick(), Status::kRunning);
  StartAssistance();
  EXPECT_TRUE(Eventually([&] { return InState(HelpRequest::OPEN) != 0; }, 20));
}

TEST_F(RosSupervisorsTest, ANodeThatHasLostTheRequestIsAskedAgain) {
  StartAssistance();
  ASSERT_TRUE(AskAndWait());
  const std::uint32_t first = InState(HelpRequest::OPEN);
  kill(assistance_.pid(), SIGKILL);
  ASSERT_TRUE(Eventually([&] { return !assistance_.IsRunning(); }));
  StartAssistance();
  EXPECT_TRUE(Eventually([&] { return InState(HelpRequest::OPEN) > first; }, 20));
  EXPECT_TRUE(Answer(true));
  EXPECT_TRUE(Eventually([&] { return harness_.Tick() == Status::kSuccess; }));
}

}  // namespace
}  // namespace coppice::robot::adapters
