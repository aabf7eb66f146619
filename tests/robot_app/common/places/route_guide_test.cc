#include "robot_app/common/places/route_guide.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "tests/robot_app/common/places/sample_map.h"

namespace coppice::robot {
namespace {

using testing::HasSubstr;

class RouteGuideTest : public testing::Test {
 protected:
  // The legs to a place, as "NAME by KIND", travelled without a mishap.
  std::vector<std::string> Legs(Pose2D robot, const char* place) {
    std::vector<std::string> legs;
    while (const auto leg = Leg_(robot, place)) {
      legs.push_back(leg->name + " by " + ToString(leg->kind));
      robot = leg->goal;
      if (legs.size() > 20) break;
    }
    return legs;
  }
  std::optional<Leg> Leg_(const Pose2D& robot, const char* place) {
    const auto leg = guide_.Next(robot, guide_.map().Find(place), now_);
    EXPECT_TRUE(leg) << leg.problem();
    return leg ? *leg : std::nullopt;
  }

  RouteGuide guide_{SampleMap()};
  const Time now_ = Time{} + std::chrono::hours(100);
  using List = std::vector<std::string>;
};

TEST_F(RouteGuideTest, EdgesThatAreDrivenOneBehindTheOtherAreOneLeg) {
  EXPECT_EQ(Legs({0, 0, 0}, "east"), List{"west -> middle -> east by drive"});
}

TEST_F(RouteGuideTest, ADoorIsALegOfItsOwn) {
  EXPECT_EQ(Legs({20, 0, 0}, "room"), (List{"east -> middle by drive", "middle -> room by door"}));
}

TEST_F(RouteGuideTest, LeavesTheStationAndDocksByTheirEdges) {
  EXPECT_EQ(Legs({-2, 0, 3}, "middle"),
            (List{"station -> west by undock", "west -> middle by drive"}));
  EXPECT_EQ(Legs({20, 0, 0}, "station"),
            (List{"east -> middle -> west by drive", "west -> station by dock"}));
}

TEST_F(RouteGuideTest, ALegLooksWhereTheWayGoesOnAndAtItsEndAsThePlaceSays) {
  EXPECT_NEAR(Leg_({20, 0, 0}, "room")->goal.yaw, M_PI / 2, 1e-9);
  EXPECT_NEAR(Leg_({10, 0, 0}, "room")->goal.yaw, 1.5, 1e-9);
}

TEST_F(RouteGuideTest, ARobotBetweenTwoPlacesGoesOnAndNotBack) {
  EXPECT_EQ(Legs({2, 0.3, 0}, "east"), List{"-> middle -> east by drive"});
  EXPECT_EQ(Legs({18, -0.3, 0}, "west"), List{"-> middle -> west by drive"});
}

TEST_F(RouteGuideTest, ARobotBesideAllEdgesGoesToTheNearestPlaceFirst) {
  EXPECT_EQ(Legs({14, -19, 0}, "middle"), List{"-> yard -> west -> middle by drive"});
}

TEST_F(RouteGuideTest, ARobotInADoorGoesOnThroughTheDoor) {
  EXPECT_EQ(Legs({10, 2, 0}, "room"), List{"-> room by door"});
}

TEST_F(RouteGuideTest, TheWayEndsWhereTheRestIsElsewhere) {
  EXPECT_EQ(Legs({0, 0, 0}, "attic"), List{"west -> middle -> east by drive"});
  const int attic = guide_.map().Find("attic");
  EXPECT_EQ(guide_.Words({20, 0, 0}, attic, "de", now_), "Nehmen Sie die Leiter.");
  EXPECT_EQ(guide_.Words({20, 0, 0}, guide_.map().Find("west"), "en", now_), "");
}

TEST_F(RouteGuideTest, ThereIsNoLegWhereTheRobotIs) { EXPECT_FALSE(Leg_({0.2, 0.1, 2}, "west")); }

TEST_F(RouteGuideTest, APlaceWithoutEdgesIsAProblem) {
  const auto leg = guide_.Next({0, 0, 0}, guide_.map().Find("island"), now_);
  EXPECT_THAT(leg.problem(), HasSubstr("\"island\""));
}

TEST_F(RouteGuideTest, GoesAroundTheEdgeThatTheRobotStandsBefore) {
  const auto leg = Leg_({0, 0, 0}, "east");
  guide_.Ended(leg->name, false, {12, 0, 0}, 60, now_);  // between middle and east
  EXPECT_EQ(Legs({10, 0, 0}, "east"), List{"middle -> west -> yard -> east by drive"});
  EXPECT_EQ(Legs({0, 0, 0}, "middle"), List{"west -> middle by drive"});
}

TEST_F(RouteGuideTest, AtAPlaceTheEdgeAheadIsTheBlockedOne) {
  guide_.Ended("west -> middle -> east", false, {10, 0, 0}, 60, now_);
  EXPECT_EQ(Legs({10, 0, 0}, "east"), List{"middle -> west -> yard -> east by drive"});
}

TEST_F(RouteGuideTest, ARobotBeforeAnObstacleOnItsEdgeTurnsBack) {
  guide_.Ended("-> east", false, {14, 0, 0}, 60, now_);
  EXPECT_EQ(Legs({14, 0, 0}, "east"), List{"-> middle -> west -> yard -> east by drive"});
}

TEST_F(RouteGuideTest, ABlockedEdgeIsTriedWhereThereIsNoOther) {
  guide_.Ended("middle -> room", false, {10, 1, 0}, 60, now_);
  EXPECT_EQ(Legs({10, 0, 0}, "room"), List{"middle -> room by door"});
}

TEST_F(RouteGuideTest, ALegThatWasTravelledTeachesItsTimes) {
  guide_.Ended("west -> middle -> east", true, {20, 0, 0}, 120, now_);
  const int edge = guide_.map().FindEdge(guide_.map().Find("west"), guide_.map().Find("middle"));
  EXPECT_DOUBLE_EQ(guide_.memory().records()[static_cast<std::size_t>(edge)].seconds, 60);
}

TEST_F(RouteGuideTest, ALegThatBeganInTheMiddleTeachesNoTimes) {
  guide_.Ended("-> middle -> east", true, {20, 0, 0}, 120, now_);
  for (const EdgeRecord& record : guide_.memory().records()) EXPECT_EQ(record.trips, 0);
}

TEST_F(RouteGuideTest, ALegThatNobodyGaveChangesNothing) {
  for (const char* const leg : {"", "->", "-> ", "nowhere -> never", "west", "a -> -> b"}) {
    guide_.Ended(leg, false, {10, 0, 0}, 60, now_);
    guide_.Ended(leg, true, {10, 0, 0}, 60, now_);
  }
  for (const EdgeRecord& record : guide_.memory().records()) {
    EXPECT_EQ(record.failures + record.trips, 0);
  }
}

TEST_F(RouteGuideTest, TheNearestOfACategoryIsThatWithTheShortestWay) {
  const auto nearest = [&](const Pose2D& robot, const char* category) {
    const auto place = guide_.Nearest(robot, category, now_);
    return place ? guide_.map().places()[static_cast<std::size_t>(*place)].name : place.problem();
  };
  EXPECT_EQ(nearest({19, 0, 0}, "lounge"), "east");
  EXPECT_EQ(nearest({0, 0, 0}, "office"), "room");
  EXPECT_THAT(nearest({0, 0, 0}, "ofice"), HasSubstr("did you mean \"office\"?"));
}

TEST_F(RouteGuideTest, NearestIsByTheWayAndNotByAir) {
  // Across the wall the yard's neighbour is nearer by air than by way.
  guide_.Ended("yard -> east", false, {15, -10, 0}, 60, now_);
  const auto place = guide_.Nearest({10, -20, 0}, "lounge", now_);
  ASSERT_TRUE(place);
  EXPECT_EQ(guide_.map().places()[static_cast<std::size_t>(*place)].name, "west");
}

}  // namespace
}  // namespace coppice::robot
