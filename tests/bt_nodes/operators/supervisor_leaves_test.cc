#include "bt_nodes/operators/supervisor_leaves.h"

#include <gtest/gtest.h>

#include <functional>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

TEST(AskSupervisor, SucceedsWhenSomebodyConfirms) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<AskSupervisor>(std::ref<SupervisorChannel>(robot));
  harness.Set("subject", std::string("navigation"));
  harness.Set("question", std::string("stuck"));
  harness.Tick();
  EXPECT_EQ(robot.calls, std::vector<std::string>{"Ask navigation: stuck"});
  robot.AnswerRequest("navigation", true);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(AskSupervisor, WithdrawsTheQuestionWhenHalted) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<AskSupervisor>(std::ref<SupervisorChannel>(robot));
  harness.Set("subject", std::string("navigation"));
  harness.Set("question", std::string("stuck"));
  harness.Tick();
  harness.Halt();
  EXPECT_EQ(robot.calls.back(), "Withdraw navigation");
}

TEST(TellSupervisor, SendsAMessageAndIsDone) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<TellSupervisor>(std::ref<SupervisorChannel>(robot));
  harness.Set("subject", std::string("cpu"));
  harness.Set("message", std::string("busy"));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(robot.calls, std::vector<std::string>{"Tell cpu: busy"});
}

}  // namespace
}  // namespace coppice::leaves
