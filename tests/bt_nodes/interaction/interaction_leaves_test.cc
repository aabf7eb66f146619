#include "bt_nodes/interaction/interaction_leaves.h"

#include <gtest/gtest.h>

#include <functional>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

TEST(Say, RunsUntilTheTextWasSpoken) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<Say>(std::ref<Interaction>(robot));
  harness.Set("text", std::string("hello"));
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(robot.calls, std::vector<std::string>{"Say hello"});
  robot.done.Send({true, ""});
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(Say, FallsSilentWhenHalted) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<Say>(std::ref<Interaction>(robot));
  harness.Set("text", std::string("hello"));
  harness.Tick();
  harness.Halt();
  EXPECT_EQ(robot.calls.back(), "CancelSpeech");
}

}  // namespace
}  // namespace coppice::leaves
