#include "bt_nodes/navigation/navigation_leaves.h"

#include <gtest/gtest.h>

#include <functional>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

TEST(LimitSpeed, SaysItAgainInEveryTick) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<LimitSpeed>(std::ref<Navigator>(robot));
  harness.Set("speed", 0.25);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  harness.Tick();
  EXPECT_EQ(robot.calls, (std::vector<std::string>{"LimitSpeed 0.25", "LimitSpeed 0.25"}));
}

TEST(NavigateTo, SendsItsGoalToTheNavigator) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<NavigateTo>(std::ref<Navigator>(robot));
  harness.Set("goal", Pose2D{1, 2, 0.5});
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(robot.calls, std::vector<std::string>{"NavigateTo 1;2;0.5"});
}

TEST(NavigateTo, CancelsTheGoalWhenHalted) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<NavigateTo>(std::ref<Navigator>(robot));
  harness.Set("goal", Pose2D{1, 2, 0});
  harness.Tick();
  harness.Halt();
  EXPECT_EQ(robot.calls.back(), "CancelNavigation");
}

TEST(NavigateTo, FailsWithoutAGoal) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<NavigateTo>(std::ref<Navigator>(robot));
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_TRUE(robot.calls.empty());
}

TEST(BackUp, MovesBackwardsByItsDefaults) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<BackUp>(std::ref<Navigator>(robot));
  harness.Tick();
  EXPECT_EQ(robot.calls, std::vector<std::string>{"Move -0.3 0.1"});
}

TEST(BackUp, StopsTheMotionWhenHalted) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<BackUp>(std::ref<Navigator>(robot));
  harness.Tick();
  harness.Halt();
  EXPECT_EQ(robot.calls.back(), "CancelMotion");
}

TEST(Rotate, TurnsByItsAngle) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<Rotate>(std::ref<Navigator>(robot));
  harness.Set("angle", 6.28);
  harness.Tick();
  EXPECT_EQ(robot.calls, std::vector<std::string>{"Rotate 6.28 0.4"});
}

TEST(Rotate, StopsTheMotionWhenHalted) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<Rotate>(std::ref<Navigator>(robot));
  harness.Set("angle", 1.0);
  harness.Tick();
  harness.Halt();
  EXPECT_EQ(robot.calls.back(), "CancelMotion");
}

TEST(ChooseWaypoint, GivesNameAndPoseOfThePlace) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<ChooseWaypoint>(std::ref<WaypointMap>(robot));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<std::string>("waypoint"), "hall");
  EXPECT_EQ(harness.Get<Pose2D>("goal").x, 46);
}

TEST(FindWaypoint, GivesThePoseOfANamedPlace) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<FindWaypoint>(std::ref<WaypointMap>(robot));
  harness.Set("waypoint", std::string("hall"));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<Pose2D>("goal").x, 46);
}

TEST(FindWaypoint, SaysWhichPlaceThereIsNot) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<FindWaypoint>(std::ref<WaypointMap>(robot));
  harness.Set("waypoint", std::string("cellar"));
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), R"(no waypoint "cellar" on the map)");
}

// A reactive node begins the more urgent branch before it halts the one that ran.
TEST(BackUp, IsNotCancelledByALeafThatIsHaltedAfterItHasBegun) {
  FakeRobot robot;
  LeafHarness rotate = LeafHarness::For<Rotate>(std::ref<Navigator>(robot));
  rotate.Set("angle", 6.28);
  rotate.Tick();
  LeafHarness back_up = LeafHarness::For<BackUp>(std::ref<Navigator>(robot));
  back_up.Tick();
  rotate.Halt();
  EXPECT_EQ(robot.calls.back(), "Move -0.3 0.1");
  back_up.Halt();
  EXPECT_EQ(robot.calls.back(), "CancelMotion");
}

}  // namespace
}  // namespace coppice::leaves
