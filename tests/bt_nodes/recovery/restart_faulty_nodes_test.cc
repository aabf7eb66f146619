#include "bt_nodes/recovery/restart_faulty_nodes.h"

#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

class RestartFaultyNodesTest : public testing::Test {
 protected:
  Status Blame(const std::vector<std::string>& nodes) {
    Health health;
    for (const std::string& node : nodes) {
      health.entries.push_back({"node", node, node, HealthLevel::kError, ""});
    }
    leaf_.Set("health", health);
    return leaf_.Tick();
  }
  Status Answer(bool ok) {
    robot_.done.Send({ok, ok ? "" : "too often"});
    return leaf_.Tick();
  }

  FakeRobot robot_;
  LeafHarness leaf_ = LeafHarness::For<RestartFaultyNodes>(std::ref<ProcessManager>(robot_),
                                                           std::ref<RecoveryLog>(robot_));
};

TEST_F(RestartFaultyNodesTest, AsksForOneRestartAfterTheOther) {
  EXPECT_EQ(Blame({"/a", "/b"}), Status::kRunning);
  EXPECT_EQ(robot_.calls.size(), 1u);
  EXPECT_EQ(Answer(true), Status::kRunning);
  EXPECT_EQ(robot_.calls.back(), "RestartNode /b");
}

TEST_F(RestartFaultyNodesTest, SucceedsWhenAllAreWell) {
  Blame({"/a"});
  Answer(true);
  EXPECT_EQ(Blame({}), Status::kSuccess);
  ASSERT_EQ(robot_.events.size(), 2u);
  EXPECT_EQ(robot_.events[0].phase, RecoveryPhase::kBegun);
  EXPECT_EQ(robot_.events[1].phase, RecoveryPhase::kSucceeded);
}

TEST_F(RestartFaultyNodesTest, FailsWhenOnlyNodesAreLeftThatNeedAPerson) {
  Blame({"/a"});
  EXPECT_EQ(Answer(false), Status::kFailure);
  EXPECT_EQ(leaf_.Get<std::string>("given_up"), "/a");
  EXPECT_EQ(leaf_.message(), "/a: too often");
  EXPECT_EQ(Blame({"/a", "/b"}), Status::kRunning);
  EXPECT_EQ(robot_.calls.back(), "RestartNode /b");
}

TEST_F(RestartFaultyNodesTest, CarriesThroughWhatItHasBegunWhenItIsHalted) {
  Blame({"/a"});
  leaf_.Halt();
  EXPECT_EQ(robot_.calls, std::vector<std::string>{"RestartNode /a"});
  EXPECT_EQ(Answer(true), Status::kRunning);
  EXPECT_EQ(robot_.calls.size(), 1u) << "it waits for the node to come up";
}

}  // namespace
}  // namespace coppice::leaves
