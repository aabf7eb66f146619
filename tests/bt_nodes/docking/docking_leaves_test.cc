#include "bt_nodes/docking/docking_leaves.h"

#include <gtest/gtest.h>

#include <functional>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

TEST(Dock, AsksTheStationToDock) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<Dock>(std::ref<ChargingStation>(robot));
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(robot.calls, std::vector<std::string>{"Dock 0 1"});
}

TEST(Dock, SaysHowFarAsideAndHowOften) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<Dock>(std::ref<ChargingStation>(robot));
  harness.Set("lateral_offset", -0.08);
  harness.Set("attempts", 3);
  harness.Tick();
  EXPECT_EQ(robot.calls, std::vector<std::string>{"Dock -0.08 3"});
}

TEST(PressOn, AsksTheStationToPressOnAndCancelsWhenHalted) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<PressOn>(std::ref<ChargingStation>(robot));
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  harness.Halt();
  EXPECT_EQ(robot.calls, (std::vector<std::string>{"PressOn", "CancelDocking"}));
}

TEST(Undock, AsksTheStationToUndock) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<Undock>(std::ref<ChargingStation>(robot));
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(robot.calls, std::vector<std::string>{"Undock"});
}

TEST(Undock, CancelsWhenHalted) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<Undock>(std::ref<ChargingStation>(robot));
  harness.Tick();
  harness.Halt();
  EXPECT_EQ(robot.calls.back(), "CancelDocking");
}

}  // namespace
}  // namespace coppice::leaves
