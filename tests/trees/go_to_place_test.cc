// The robot is led to a place leg by leg, with the real leaves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/trees/tree_scenario.h"

namespace coppice {
namespace {

using leaves::Pose2D;
using testing::ElementsAre;
using testing::IsEmpty;

class GoToPlace : public testing::Test {
 protected:
  void Go(const std::string& place, std::vector<leaves::RouteLeg> legs) {
    scenario_.robot.legs = std::move(legs);
    scenario_.Set("place", place);
    scenario_.Set("pose", Pose2D{0, 0, 0});
    scenario_.Set("docked", true);
    scenario_.Set("language", std::string("en"));
    scenario_.Set("announce", false);
    scenario_.Set("attempts", 40);
    scenario_.Tick();
  }
  // The calls since the last time.
  std::vector<std::string> Calls() { return std::exchange(scenario_.robot.calls, {}); }

  TreeScenario scenario_{"behavior/go_to_place.xml"};
  const Time start_ = scenario_.now();
};

TEST_F(GoToPlace, TravelsTheLegsOneAfterTheOther) {
  Go("office", {{"a -> b", "drive", {1, 0, 0}, "b"}, {"b -> office", "door", {2, 0, 0}, "office"}});
  EXPECT_THAT(Calls(), ElementsAre("NavigateTo 1;0;0"));
  scenario_.Answer(true);
  EXPECT_THAT(Calls(), ElementsAre("travelled a -> b"));
  scenario_.Tick();
  EXPECT_THAT(Calls(), ElementsAre("FindWay 2;0;0"));
  scenario_.Answer(true);
  EXPECT_THAT(Calls(), ElementsAre("NavigateTo 2;0;0"));
  scenario_.Answer(true);
  EXPECT_EQ(scenario_.Tick(), Status::kSuccess);
  EXPECT_THAT(Calls(), ElementsAre("travelled b -> office"));
}

TEST_F(GoToPlace, IsDoneAtOnceWhereItIs) {
  Go("office", {});
  EXPECT_EQ(scenario_.Tick(), Status::kSuccess);
  EXPECT_THAT(Calls(), IsEmpty());
}

TEST_F(GoToPlace, FailsAtOnceForAPlaceThatThereIsNot) {
  Go("nowhere", {});
  EXPECT_EQ(scenario_.StatusOf("known_place"), Status::kFailure);
  EXPECT_THAT(Calls(), IsEmpty());
}

TEST_F(GoToPlace, RemembersABlockedLegAndTriesAgainAfterAPause) {
  Go("office", {{"a -> b", "drive", {1, 0, 0}, "b"}});
  scenario_.Answer(false);
  scenario_.Tick();
  EXPECT_THAT(Calls(), ElementsAre("NavigateTo 1;0;0", "blocked a -> b"));
  EXPECT_TRUE(scenario_.Runs("pause_before_the_next_try"));
  scenario_.Advance(5);
  scenario_.Tick();
  EXPECT_THAT(Calls(), ElementsAre("NavigateTo 1;0;0"));
}

TEST_F(GoToPlace, TakesAnotherWayWhenThereIsOne) {
  Go("office", {{"a -> office", "door", {1, 0, 0}, ""}});
  while (Calls() != std::vector<std::string>{"blocked a -> office"}) {
    scenario_.Answer(false);
    scenario_.Advance(1);
    scenario_.Tick();
    ASSERT_LT(scenario_.now(), start_ + std::chrono::minutes(10));
  }
  scenario_.robot.legs = {{"a -> b -> office", "drive", {1, 0, 0}, ""}};
  scenario_.Advance(5);
  scenario_.Tick();
  scenario_.Tick();
  EXPECT_THAT(Calls(), ElementsAre("NavigateTo 1;0;0"));
}

TEST_F(GoToPlace, GivesUpADoorThatNobodyOpens) {
  Go("office", {{"a -> office", "door", {1, 0, 0}, ""}});
  Status status = Status::kRunning;
  while (status == Status::kRunning && scenario_.now() < start_ + std::chrono::minutes(10)) {
    scenario_.Answer(scenario_.LastCall().rfind("Say", 0) == 0);
    scenario_.Advance(1);
    status = scenario_.Tick();
  }
  EXPECT_EQ(status, Status::kFailure);
  EXPECT_LT(scenario_.now(), start_ + std::chrono::minutes(3));
  EXPECT_EQ(scenario_.CallsBeginning("blocked"), 1);
  EXPECT_EQ(scenario_.CallsBeginning("NavigateTo"), 0);
  EXPECT_GE(scenario_.CallsBeginning("Say This door is closed"), 1);
}

TEST_F(GoToPlace, TellsTheWayToAnotherFloorWhereItEnds) {
  Go("upstairs", {{"a -> stairs", "drive", {1, 0, 0}, ""}});
  scenario_.Answer(true);
  scenario_.Tick();
  EXPECT_EQ(scenario_.LastCall(), "Say Take the stairs.");
  EXPECT_EQ(scenario_.Answer(true), Status::kSuccess);
}

TEST_F(GoToPlace, LeavesTheStationAndDocksByTheirOwnTrees) {
  Go("station",
     {{"station -> a", "undock", {1, 0, 0}, ""}, {"a -> station", "dock", {2, 0, 0}, ""}});
  scenario_.Answer(true);  // has said good morning
  EXPECT_EQ(scenario_.LastCall(), "Undock");
  scenario_.Answer(true);
  scenario_.Tick();
  EXPECT_EQ(scenario_.LastCall(), "Dock 0 1");
  scenario_.Answer(true);
  EXPECT_EQ(scenario_.Tick(), Status::kSuccess);
}

TEST_F(GoToPlace, CancelsWhatItDoesWhenHaltedAndRemembersNothing) {
  Go("office", {{"a -> b", "drive", {1, 0, 0}, "b"}});
  scenario_.Halt();
  EXPECT_THAT(Calls(), ElementsAre("NavigateTo 1;0;0", "CancelNavigation"));
}

}  // namespace
}  // namespace coppice
