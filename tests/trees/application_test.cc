// The patrol and the behaviours that it is made of.
#include <gtest/gtest.h>

#include "tests/trees/tree_scenario.h"

namespace coppice {
namespace {

class Application : public testing::Test {
 protected:
  Application() {
    scenario_.Set("rounds", 1);
    scenario_.Set("stops", 2);
    scenario_.Set("battery_level", 0.9);
    scenario_.Set("charging", false);
  }
  // Answers whatever the robot was asked with success, until the tree has asked for `call` or
  // nothing happens.
  void Until(const std::string& call) {
    scenario_.Tick();
    for (int i = 0; i < 50 && scenario_.LastCall() != call; ++i) scenario_.Answer(true);
    ASSERT_EQ(scenario_.LastCall(), call);
  }
  TreeScenario scenario_{"application/patrol.xml"};
};

TEST_F(Application, DrivesToAPlaceFirst) {
  scenario_.Tick();
  EXPECT_EQ(scenario_.LastCall(), "NavigateTo 46;0;1");
}

TEST_F(Application, LeavesTheStationWhenItStandsOnIt) {
  scenario_.Set("charging", true);
  Until("Undock");
}

TEST_F(Application, GoesHomeAfterTheLastRound) {
  Until("Dock");
  EXPECT_EQ(scenario_.Answer(true), Status::kSuccess);
  EXPECT_EQ(scenario_.CallsOf("Say All quiet here."), 2);
}

TEST_F(Application, BreaksOffThePatrolWhenTheBatteryIsLow) {
  scenario_.Tick();
  scenario_.Set("battery_level", 0.2);
  scenario_.Tick();
  EXPECT_EQ(scenario_.CallsOf("CancelNavigation"), 1);
  EXPECT_EQ(scenario_.StatusOf("recharge_when_low"), Status::kRunning);
}

TEST_F(Application, StaysOnTheStationUntilTheBatteryIsFull) {
  scenario_.Set("battery_level", 0.2);
  Until("Dock");
  scenario_.Set("charging", true);
  scenario_.Answer(true);
  scenario_.Set("battery_level", 0.5);
  EXPECT_EQ(scenario_.Tick(), Status::kRunning);
  EXPECT_EQ(scenario_.LastCall(), "SetExpression SLEEP");
}

TEST(DriveTo, TriesAgainAfterAPause) {
  TreeScenario scenario("behavior/drive_to.xml");
  scenario.Set("goal", Pose2D{1, 2, 0});
  scenario.Tick();
  EXPECT_EQ(scenario.Answer(false), Status::kRunning);
  EXPECT_EQ(scenario.CallsOf("NavigateTo 1;2;0"), 1);
  scenario.Advance(5);
  scenario.Tick();
  EXPECT_EQ(scenario.CallsOf("NavigateTo 1;2;0"), 2);
}

TEST(DriveTo, GivesUpAfterFortyAttempts) {
  TreeScenario scenario("behavior/drive_to.xml");
  scenario.Set("goal", Pose2D{1, 2, 0});
  Status status = scenario.Tick();
  for (int i = 0; i < 200 && status == Status::kRunning; ++i) {
    scenario.Answer(false);
    scenario.Advance(5);
    status = scenario.Tick();
  }
  EXPECT_EQ(status, Status::kFailure);
  EXPECT_EQ(scenario.CallsOf("NavigateTo 1;2;0"), 40);
}

TEST(LeaveStation, WaitsUntilTheBatteryHasReported) {
  TreeScenario scenario("behavior/leave_station.xml");
  EXPECT_EQ(scenario.Tick(), Status::kRunning);
  scenario.Set("charging", true);
  scenario.Tick();
  EXPECT_EQ(scenario.LastCall(), "Say Good morning.");
}

TEST(LeaveStation, DoesNothingAwayFromTheStation) {
  TreeScenario scenario("behavior/leave_station.xml");
  scenario.Set("charging", false);
  EXPECT_EQ(scenario.Tick(), Status::kSuccess);
  EXPECT_TRUE(scenario.robot.calls.empty());
}

}  // namespace
}  // namespace coppice
