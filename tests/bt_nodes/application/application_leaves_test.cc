#include "bt_nodes/application/application_leaves.h"

#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

using Calls = std::vector<std::string>;

TEST(RequestCharge, SaysItAtOnceAndThenNowAndThen) {
  FakeRobot robot;
  LeafHarness leaf = LeafHarness::For<RequestCharge>(std::ref<ApplicationControl>(robot));
  leaf.Set("requested", false);
  EXPECT_EQ(leaf.Tick(), Status::kSuccess);
  leaf.Tick();
  EXPECT_EQ(robot.calls, Calls{"SetChargeRequested false"});
  leaf.Set("requested", true);
  leaf.Tick();
  EXPECT_EQ(robot.calls.back(), "SetChargeRequested true");
  leaf.Advance(std::chrono::seconds(5));
  leaf.Tick();
  EXPECT_EQ(robot.calls.size(), 3u);
}

TEST(AnnounceGoingHome, SaysWhenItBeginsAndWhenItEnds) {
  FakeRobot robot;
  LeafHarness leaf =
      LeafHarness::WithChildren<AnnounceGoingHome>(1, std::ref<ApplicationControl>(robot));
  leaf.SetChild(0, {Status::kRunning});
  leaf.Tick();
  leaf.Tick();
  EXPECT_EQ(robot.calls, Calls{"SetGoingHome true"});
  leaf.Halt();
  EXPECT_EQ(robot.calls.back(), "SetGoingHome false");
  leaf.SetChild(0, {Status::kSuccess});
  EXPECT_EQ(leaf.Tick(), Status::kSuccess);
  EXPECT_EQ(robot.calls.back(), "SetGoingHome false");
}

TEST(SuspendApplication, ResumesItHoweverTheChildEnds) {
  FakeRobot robot;
  LeafHarness leaf =
      LeafHarness::WithChildren<SuspendApplication>(1, std::ref<ApplicationControl>(robot));
  leaf.SetChild(0, {Status::kRunning});
  leaf.Tick();
  EXPECT_EQ(robot.calls, Calls{"Suspend"});
  leaf.Halt();
  EXPECT_EQ(robot.calls.back(), "Resume");
  leaf.SetChild(0, {Status::kFailure});
  EXPECT_EQ(leaf.Tick(), Status::kFailure);
  EXPECT_EQ(robot.calls, (Calls{"Suspend", "Resume", "Suspend", "Resume"}));
}

}  // namespace
}  // namespace coppice::leaves
