#include "bt_nodes/basics/capability_action.h"

#include <gtest/gtest.h>

#include <functional>

#include "bt_core/testing/leaf_harness.h"
#include "bt_nodes/docking/docking_leaves.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

class CapabilityActionTest : public testing::Test {
 protected:
  FakeRobot robot_;
  LeafHarness harness_ = LeafHarness::For<Dock>(std::ref(robot_));
};

TEST_F(CapabilityActionTest, RunsUntilTheCapabilityAnswers) {
  EXPECT_EQ(harness_.Tick(), Status::kRunning);
  EXPECT_EQ(harness_.Tick(), Status::kRunning);
  robot_.done.Send({true, ""});
  EXPECT_EQ(harness_.Tick(), Status::kSuccess);
}

TEST_F(CapabilityActionTest, FailsWithTheReasonOfTheCapability) {
  harness_.Tick();
  robot_.done.Send({false, "no current"});
  EXPECT_EQ(harness_.Tick(), Status::kFailure);
  EXPECT_EQ(harness_.message(), "no current");
}

TEST_F(CapabilityActionTest, CancelsWhenHalted) {
  harness_.Tick();
  harness_.Halt();
  EXPECT_EQ(robot_.calls.back(), "CancelDocking");
}

TEST_F(CapabilityActionTest, CancelsNothingThatHasEnded) {
  harness_.Tick();
  robot_.done.Send({true, ""});
  harness_.Tick();
  harness_.Halt();
  EXPECT_EQ(robot_.calls, std::vector<std::string>{"Dock 0 1"});
}

TEST_F(CapabilityActionTest, DoesNotSeeTheAnswerToAnEarlierActivation) {
  harness_.Tick();
  const Sender<ActionResult> old = robot_.done;
  harness_.Halt();
  harness_.Tick();
  old.Send({true, ""});
  EXPECT_EQ(harness_.Tick(), Status::kRunning);
  robot_.done.Send({false, "new"});
  EXPECT_EQ(harness_.Tick(), Status::kFailure);
}

TEST_F(CapabilityActionTest, KeepsTheNewAnswerWhenAnOldOneComesLate) {
  harness_.Tick();
  const Sender<ActionResult> old = robot_.done;
  harness_.Halt();
  harness_.Tick();
  robot_.done.Send({true, ""});
  old.Send({false, "late"});
  EXPECT_EQ(harness_.Tick(), Status::kSuccess);
}

}  // namespace
}  // namespace coppice::leaves
