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

// One begins in the tick in which the other is halted.
TEST(AnnounceGoingHome, TheRobotGoesHomeAsLongAsOneOfSeveralIsActive) {
  FakeRobot robot;
  const auto active = std::make_shared<int>(0);
  const auto application = std::ref<ApplicationControl>(robot);
  LeafHarness patrol = LeafHarness::WithChildren<AnnounceGoingHome>(1, application, active);
  LeafHarness charge = LeafHarness::WithChildren<AnnounceGoingHome>(1, application, active);
  for (LeafHarness* leaf : {&patrol, &charge}) {
    leaf->SetChild(0, {Status::kRunning});
    leaf->Tick();
  }
  patrol.Halt();
  EXPECT_EQ(robot.calls, Calls{"SetGoingHome true"});
  charge.Halt();
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

TEST(IsOffDuty, OnlyARobotThatKnowsItsHoursIsEverOffDuty) {
  LeafHarness harness = LeafHarness::For<IsOffDuty>();
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  harness.Set("duty_left", 1.0);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  harness.Set("duty_left", 0.0);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

}  // namespace
}  // namespace coppice::leaves
