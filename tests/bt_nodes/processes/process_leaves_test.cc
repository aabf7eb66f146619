#include "bt_nodes/processes/process_leaves.h"

#include <gtest/gtest.h>

#include <functional>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

TEST(RestartNode, AsksForTheRestartOfItsNode) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<RestartNode>(std::ref<ProcessManager>(robot));
  harness.Set("node", std::string("/navigation"));
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(robot.calls, std::vector<std::string>{"RestartNode /navigation"});
}

TEST(RestartNode, AsksForAClearedStateWhereTheTreeWantsOne) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<RestartNode>(std::ref<ProcessManager>(robot));
  harness.Set("node", std::string("/localization"));
  harness.Set("cleared", true);
  harness.Tick();
  EXPECT_EQ(robot.calls, std::vector<std::string>{"RestartNode /localization, cleared"});
}

TEST(RestartNode, FailsWhenTheRestartIsRefused) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<RestartNode>(std::ref<ProcessManager>(robot));
  harness.Set("node", std::string("/navigation"));
  harness.Tick();
  robot.done.Send({false, "restarted too often"});
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "restarted too often");
}

TEST(SwitchSite, AsksForTheSiteAndSucceedsWhenTheRobotIsThere) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<SwitchSite>(std::ref<ProcessManager>(robot));
  harness.Set("site", std::string("campus"));
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(robot.calls, std::vector<std::string>{"SetSite campus"});
  robot.done.Send({true, ""});
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(SwitchSite, FailsWhenTheSiteIsRefused) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<SwitchSite>(std::ref<ProcessManager>(robot));
  harness.Set("site", std::string("campus"));
  harness.Tick();
  robot.done.Send({false, "no site \"campus\""});
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "no site \"campus\"");
}

TEST(SwitchOff, SaysWhyAndEndsWhenItHasBegun) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<SwitchOff>(std::ref<ProcessManager>(robot));
  harness.Set("reason", std::string("the battery is empty"));
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(robot.calls, std::vector<std::string>{"SwitchOff the battery is empty"});
  robot.done.Send({true, ""});
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

class SwitchConfigurationTest : public testing::Test {
 protected:
  SwitchConfigurationTest() { harness_.Set("configuration", std::string("charging")); }
  FakeRobot robot_;
  LeafHarness harness_ = LeafHarness::For<SwitchConfiguration>(std::ref<ProcessManager>(robot_));
};

TEST_F(SwitchConfigurationTest, AsksWhenAnotherOneIsInForce) {
  harness_.Set("current", std::string("operating"));
  EXPECT_EQ(harness_.Tick(), Status::kSuccess);
  EXPECT_EQ(robot_.calls, std::vector<std::string>{"SetConfiguration charging"});
}

TEST_F(SwitchConfigurationTest, AsksNothingWhenItIsInForce) {
  harness_.Set("current", std::string("charging"));
  EXPECT_EQ(harness_.Tick(), Status::kSuccess);
  EXPECT_TRUE(robot_.calls.empty());
}

TEST_F(SwitchConfigurationTest, AsksAgainOnlyAfterAPeriod) {
  harness_.Tick();
  harness_.Advance(std::chrono::seconds(4));
  harness_.Tick();
  EXPECT_EQ(robot_.calls.size(), 1u);
  harness_.Advance(std::chrono::seconds(1));
  harness_.Tick();
  EXPECT_EQ(robot_.calls.size(), 2u);
}

TEST_F(SwitchConfigurationTest, AsksAtOnceForAnotherConfiguration) {
  harness_.Tick();
  harness_.Set("configuration", std::string("mapping"));
  harness_.Tick();
  EXPECT_EQ(robot_.calls.back(), "SetConfiguration mapping");
}

}  // namespace
}  // namespace coppice::leaves
