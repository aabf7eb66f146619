// The patrol and the behaviours that it is made of.
#include <gtest/gtest.h>

#include "bt_nodes/people/people_view.h"
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
    scenario_.Set("docked", false);
    scenario_.Set("pose", leaves::Pose2D{1, 0, 0});
  }
  // Answers whatever the robot was asked with success, until the tree has asked for `call` or
  // nothing happens.
  void Until(const std::string& call) {
    scenario_.Tick();
    for (int i = 0; i < 50 && scenario_.LastCall() != call; ++i) {
      scenario_.Answer(scenario_.LastCall() != "PressOn");  // not on the station yet
    }
    ASSERT_EQ(scenario_.LastCall(), call);
  }
  TreeScenario scenario_{"application/patrol.xml"};
};

TEST_F(Application, DrivesFirstToAPlaceToWhichAWayIsFree) {
  scenario_.Tick();
  scenario_.Answer(true);
  EXPECT_EQ(scenario_.LastCall(), "NavigateTo 46;0;1");
}

TEST_F(Application, LeavesTheStationWhenItStandsOnIt) {
  scenario_.Set("charging", true);
  scenario_.Set("docked", true);
  Until("Undock");
}

TEST_F(Application, LeavesTheStationWhenItStandsOnItWithAFullBattery) {
  scenario_.Set("docked", true);  // and no current flows
  Until("Undock");
}

TEST_F(Application, DoesNotNavigateOutOfTheStationThatGivesNoCurrent) {
  scenario_.Set("docked", true);
  scenario_.Set("battery_level", 0.2);
  Until("PressOn");
  scenario_.Answer(false);
  EXPECT_EQ(scenario_.LastCall(), "Undock");
  scenario_.Answer(true);
  EXPECT_EQ(scenario_.CallsBeginning("NavigateTo"), 1);
}

TEST_F(Application, GoesHomeWhenTheLevelOfTheBatteryIsNotKnown) {
  scenario_.Tick();
  scenario_.Set("battery_level", -1.0);
  scenario_.Tick();
  EXPECT_EQ(scenario_.StatusOf("recharge_when_low"), Status::kRunning);
}

TEST_F(Application, GoesHomeAfterTheLastRound) {
  Until("Dock 0 1");
  EXPECT_EQ(scenario_.Answer(true), Status::kSuccess);
  EXPECT_EQ(scenario_.CallsOf("Say All quiet here."), 2);
}

TEST_F(Application, RemembersTheWaysOfItsPatrol) {
  Until("NavigateTo 46;0;1");
  scenario_.Answer(true);
  EXPECT_EQ(scenario_.CallsOf("travelled -> hall"), 1);
}

TEST_F(Application, EndsItsWorkAtTheMeetingPointWhereThereIsNoStation) {
  scenario_.Set("configuration", std::string("away"));
  scenario_.Set("battery_level", 0.2);  // not enough to make it go home
  Until("NavigateTo 46;0;1");
  scenario_.robot.legs = {{"hall -> lift", "drive", {2, 0, 0}, "the lift"}};
  scenario_.Set("charge_requested", true);
  scenario_.Tick();
  EXPECT_EQ(scenario_.CallsOf("SetGoingHome true"), 1);
  EXPECT_EQ(scenario_.LastCall(), "NavigateTo 2;0;0");
  scenario_.Answer(true);
  scenario_.Tick();
  EXPECT_EQ(scenario_.CallsBeginning("Ask pick up"), 1);
  scenario_.Advance(1800);
  scenario_.Tick();
  EXPECT_EQ(scenario_.LastCall(), "SwitchOff to be picked up");
  EXPECT_EQ(scenario_.CallsBeginning("Dock"), 0);
}

TEST_F(Application, BreaksOffThePatrolWhenTheBatteryIsLow) {
  Until("NavigateTo 46;0;1");
  scenario_.Set("battery_level", 0.2);
  scenario_.Tick();
  EXPECT_EQ(scenario_.CallsOf("CancelNavigation"), 1);
  EXPECT_EQ(scenario_.StatusOf("recharge_when_low"), Status::kRunning);
}

TEST_F(Application, StaysOnTheStationUntilTheBatteryIsFull) {
  scenario_.Set("battery_level", 0.2);
  Until("Dock 0 1");
  scenario_.Set("charging", true);
  scenario_.Set("docked", true);
  scenario_.Answer(true);
  scenario_.Set("battery_level", 0.5);
  EXPECT_EQ(scenario_.Tick(), Status::kRunning);
  EXPECT_EQ(scenario_.LastCall(), "SetExpression SLEEP");
}

TEST_F(Application, GoesOnPatrollingWhenTheBatteryIsFull) {
  scenario_.Set("battery_level", 0.2);
  Until("Dock 0 1");
  scenario_.Set("charging", true);
  scenario_.Set("docked", true);
  scenario_.Answer(true);
  scenario_.Set("battery_level", 0.96);
  EXPECT_EQ(scenario_.Tick(), Status::kRunning);
  EXPECT_EQ(scenario_.LastCall(), "Say Good morning.");
}

TEST_F(Application, ObeysTheBatteryWatchdogAndSaysSo) {
  Until("NavigateTo 46;0;1");
  scenario_.Set("charge_requested", true);
  scenario_.Tick();
  EXPECT_EQ(scenario_.CallsOf("CancelNavigation"), 1);
  EXPECT_EQ(scenario_.CallsOf("SetGoingHome true"), 1);
  EXPECT_TRUE(scenario_.Runs("recharge_when_low"));
}

// The fault of 4 March: a docking that failed ended everything.
TEST_F(Application, IsNotEndedByADockingThatFails) {
  scenario_.Set("battery_level", 0.2);
  Until("Dock 0 1");
  for (int i = 0; i < 6; ++i) EXPECT_EQ(scenario_.Answer(false), Status::kRunning);
  EXPECT_EQ(scenario_.CallsBeginning("Ask docking"), 1);
  scenario_.robot.AnswerRequest("docking", false);
  scenario_.Tick();
  scenario_.Advance(30);
  EXPECT_EQ(scenario_.Tick(), Status::kRunning);
  EXPECT_EQ(scenario_.LastCall(), "PressOn") << "and begins anew";
}

// The fault of 12 March: docked, but not charging.
TEST_F(Application, PressesOnWhenTheCurrentStopsBeforeTheBatteryIsFull) {
  scenario_.Set("battery_level", 0.2);
  Until("Dock 0 1");
  scenario_.Set("charging", true);
  scenario_.Set("docked", true);
  scenario_.Answer(true);
  scenario_.Set("charging", false);
  scenario_.Set("docked", false);
  EXPECT_EQ(scenario_.Tick(), Status::kRunning);
  EXPECT_EQ(scenario_.LastCall(), "PressOn");
}

TEST_F(Application, LeavesOutAPlaceThatCannotBeReached) {
  Status status = scenario_.Tick();
  for (int i = 0; i < 800 && scenario_.CallsOf("SetGoingHome true") == 0; ++i) {
    ASSERT_EQ(status, Status::kRunning);
    scenario_.Answer(false);
    scenario_.Advance(5);
    status = scenario_.Tick();
  }
  EXPECT_EQ(scenario_.CallsBeginning("Say All quiet"), 0);
  EXPECT_EQ(scenario_.CallsOf("SetGoingHome true"), 1) << "two places left out, then home";
}

TEST_F(Application, AsksWhoWearsNoMaskToPutOneOnOnTheWayAndOnlyOnce) {
  leaves::SeenPerson without;
  without.id = 7;
  without.x = 1.5;
  without.mask = leaves::Mask::kWithout;
  Until("NavigateTo 46;0;1");
  for (int i = 0; i < 4; ++i) {
    scenario_.Set("people", leaves::PeopleView{scenario_.now(), {without}});
    scenario_.Tick();
    if (scenario_.LastCall().rfind("Say", 0) == 0) scenario_.Answer(true);
    scenario_.Advance(0.5);
  }
  EXPECT_EQ(scenario_.CallsOf("Say Please put on a mask. Thank you!"), 1);
  EXPECT_EQ(scenario_.CallsBeginning("NavigateTo"), 1) << "and drives on";
  EXPECT_EQ(scenario_.CallsOf("CancelNavigation"), 0);
}

TEST(LeaveStation, IsNotEndedByAnUndockingThatFails) {
  TreeScenario scenario("behavior/leave_station.xml");
  scenario.Set("charging", true);
  scenario.Set("docked", true);
  scenario.Tick();
  scenario.Answer(true);
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(scenario.LastCall(), "Undock");
    scenario.Answer(false);
    scenario.Advance(5);
    EXPECT_EQ(scenario.Tick(), Status::kRunning);
  }
  EXPECT_EQ(scenario.CallsBeginning("Ask undocking"), 1);
  scenario.robot.AnswerRequest("undocking", true);
  scenario.Tick();
  scenario.Tick();
  EXPECT_EQ(scenario.LastCall(), "Undock");
  EXPECT_EQ(scenario.Answer(true), Status::kSuccess);
}

TEST(DriveTo, TriesAgainAfterAPause) {
  TreeScenario scenario("behavior/drive_to.xml");
  scenario.Set("goal", leaves::Pose2D{1, 2, 0});
  scenario.Tick();
  EXPECT_EQ(scenario.Answer(false), Status::kRunning);
  EXPECT_EQ(scenario.CallsOf("NavigateTo 1;2;0"), 1);
  scenario.Advance(5);
  scenario.Tick();
  EXPECT_EQ(scenario.CallsOf("NavigateTo 1;2;0"), 2);
}

TEST(DriveTo, GivesUpAfterFortyAttempts) {
  TreeScenario scenario("behavior/drive_to.xml");
  scenario.Set("goal", leaves::Pose2D{1, 2, 0});
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
  scenario.Set("docked", true);
  scenario.Tick();
  EXPECT_EQ(scenario.LastCall(), "Say Good morning.");
}

TEST(LeaveStation, DoesNothingAwayFromTheStation) {
  TreeScenario scenario("behavior/leave_station.xml");
  scenario.Set("charging", false);
  scenario.Set("docked", false);
  EXPECT_EQ(scenario.Tick(), Status::kSuccess);
  EXPECT_TRUE(scenario.robot.calls.empty());
}

}  // namespace
}  // namespace coppice
