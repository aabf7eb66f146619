#include "robot_app/common/places/site_places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <set>
#include <stdexcept>
#include <vector>

#include "tests/support/folders.h"

namespace coppice::robot {
namespace {

using testing::HasSubstr;

const std::string kShipped = SourceFolder() + "/robot_app/config/sites/institute/places.yaml";
constexpr Pose2D kHall{46, 0, 0};

class SitePlacesTest : public testing::Test {
 protected:
  std::string LegTo(SitePlaces& places, const Pose2D& robot, const std::string& place) {
    const auto leg = places.NextLeg(robot, place, "en");
    if (!leg) return leg.problem();
    return *leg ? (*leg)->kind + " " + (*leg)->name : "there";
  }

  SimulatedClock clock_;
  SitePlaces places_{kShipped, 1, clock_};
};

TEST_F(SitePlacesTest, FindsThePlaceInFrontOfTheStation) {
  leaves::Waypoint waypoint;
  ASSERT_TRUE(places_.Find("staging", waypoint));
  EXPECT_DOUBLE_EQ(waypoint.pose.x, -0.8);
}

TEST_F(SitePlacesTest, KnowsNoOtherNamesAndDrivesNotToOtherFloors) {
  leaves::Waypoint waypoint;
  EXPECT_FALSE(places_.Find("cellar", waypoint));
  EXPECT_FALSE(places_.Find("seminar_201", waypoint));
}

TEST_F(SitePlacesTest, NeverChoosesTheSamePlaceTwiceInARow) {
  std::string last;
  for (int i = 0; i < 200; ++i) {
    const std::string name = places_.ChooseForPatrol().name;
    EXPECT_NE(name, last);
    last = name;
  }
}

TEST_F(SitePlacesTest, ChoosesEveryPlaceOfThePatrolSometime) {
  std::set<std::string> chosen;
  for (int i = 0; i < 200; ++i) chosen.insert(places_.ChooseForPatrol().name);
  EXPECT_EQ(chosen.size(), 8u);
}

TEST_F(SitePlacesTest, GivesTheSameOrderForTheSameSeed) {
  SitePlaces a(kShipped, 5, clock_), b(kShipped, 5, clock_);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(a.ChooseForPatrol().name, b.ChooseForPatrol().name);
}

TEST_F(SitePlacesTest, RefusesAFileWithoutPatrol) {
  const std::string path = testing::TempDir() + "no_patrol.yaml";
  std::ofstream(path) << "places:\n  - {name: a, x: 0, y: 0, categories: [office]}\n";
  EXPECT_THROW(SitePlaces(path, 1, clock_), std::runtime_error);
}

TEST_F(SitePlacesTest, LeadsToAnOfficeThroughItsDoor) {
  EXPECT_EQ(LegTo(places_, kHall, "office_103"),
            "drive hall -> corridor_east -> corridor_104 -> corridor_103");
  EXPECT_EQ(LegTo(places_, {24, 0, 0}, "office_103"), "door corridor_103 -> office_103");
  EXPECT_EQ(LegTo(places_, {24, 3.6, 0}, "office_103"), "there");
}

TEST_F(SitePlacesTest, NamesTheEndOfALegInTheLanguageThatIsSpoken) {
  const auto leg = places_.NextLeg({24, 0, 0}, "office_103", "de");
  ASSERT_TRUE(leg && *leg);
  EXPECT_EQ((*leg)->spoken, "Büro 103");
}

TEST_F(SitePlacesTest, LookingWhetherTheRobotIsThereBeginsNoLeg) {
  LegTo(places_, {20, 0, 0}, "corridor_103");
  clock_.Advance(std::chrono::seconds(20));
  EXPECT_FALSE(places_.IsAt({20, 0, 0}, "hall"));
  EXPECT_TRUE(places_.IsAt(kHall, "hall"));
  clock_.Advance(std::chrono::seconds(10));
  places_.Ended("corridor_middle -> corridor_103", true, {24, 0, 0});
  const TopologicalMap& map = places_.guide().map();
  const auto edge =
      static_cast<std::size_t>(map.FindEdge(map.Find("corridor_middle"), map.Find("corridor_103")));
  EXPECT_DOUBLE_EQ(places_.guide().memory().records()[edge].seconds, 30);
}

TEST_F(SitePlacesTest, AMisspeltPlaceGetsTheNearestName) {
  EXPECT_THAT(LegTo(places_, kHall, "ofice_103"), HasSubstr("did you mean \"office_103\"?"));
}

TEST_F(SitePlacesTest, TellsTheWayToAnotherFloorInTheLanguageThatIsSpoken) {
  const auto description = places_.Describe(kHall, "seminar_201", "de");
  ASSERT_TRUE(description);
  EXPECT_EQ(description->spoken, "Seminarraum 201");
  EXPECT_THAT(description->words, HasSubstr("im zweiten Stock"));
}

TEST_F(SitePlacesTest, WhatItLearntOutlivesTheProgram) {
  const std::string memory = testing::TempDir() + "ways.yaml";
  std::remove(memory.c_str());
  const Pose2D before_door{24, 0.4, 0};
  {
    SitePlaces places(kShipped, 1, clock_, memory);
    LegTo(places, {20, 0, 0}, "corridor_103");
    clock_.Advance(std::chrono::seconds(30));
    places.Ended("corridor_middle -> corridor_103", true, before_door);
    places.Ended("corridor_103 -> office_103", false, before_door);
  }  // waits until it is written
  RouteGuide guide(places_.guide().map());
  Diagnostics diagnostics;
  guide.memory().Read(memory, clock_.Now(), diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
  const auto edge = [&](const char* from, const char* to) {
    return static_cast<std::size_t>(
        guide.map().FindEdge(guide.map().Find(from), guide.map().Find(to)));
  };
  EXPECT_DOUBLE_EQ(guide.memory().records()[edge("corridor_middle", "corridor_103")].seconds, 30);
  EXPECT_EQ(guide.memory().records()[edge("corridor_103", "office_103")].failures, 1);
}

TEST_F(SitePlacesTest, WhoShowsTheWaysHearsOfEachLeg) {
  std::vector<int> trips;  // of all edges
  places_.ShowWays([&](const RouteGuide& guide) {
    trips.push_back(0);
    for (const EdgeRecord& record : guide.memory().records()) trips.back() += record.trips;
  });
  LegTo(places_, {20, 0, 0}, "corridor_103");
  clock_.Advance(std::chrono::seconds(10));
  places_.Ended("corridor_middle -> corridor_103", true, {24, 0, 0});
  EXPECT_EQ(trips, (std::vector<int>{0, 1}));
}

TEST_F(SitePlacesTest, AMemoryThatIsBrokenDoesNotKeepTheRobotFromStarting) {
  const std::string memory = testing::TempDir() + "broken_ways.yaml";
  std::ofstream(memory) << "edges: [nonsense";
  SitePlaces places(kShipped, 1, clock_, memory);
  EXPECT_EQ(LegTo(places, {24, 0, 0}, "office_103"), "door corridor_103 -> office_103");
}

}  // namespace
}  // namespace coppice::robot
