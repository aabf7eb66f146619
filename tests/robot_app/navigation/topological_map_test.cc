#include "robot_app/navigation/topological_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "tests/support/folders.h"

namespace coppice::robot::navigation {
namespace {

using testing::HasSubstr;

std::string Write(const std::string& text) {
  const std::string path =
      testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name() + ".yaml";
  std::ofstream(path) << text;
  return path;
}

std::string ErrorsOf(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(TopologicalMap::Load(Write(text), diagnostics));
  return diagnostics.ToString();
}

TopologicalMap Shipped() {
  Diagnostics diagnostics;
  auto map = TopologicalMap::Load(SourceFolder() + "/robot_app/config/waypoints.yaml", diagnostics);
  EXPECT_TRUE(map) << diagnostics.ToString();
  return map.value_or(TopologicalMap());
}

TEST(TopologicalMap, LoadsTheShippedFile) {
  const TopologicalMap map = Shipped();
  ASSERT_GE(map.Find("hall"), 0);
  EXPECT_DOUBLE_EQ(map.places()[map.Find("hall")].pose.x, 46);
  EXPECT_EQ(map.Find("nowhere"), -1);
}

TEST(TopologicalMap, JoinsEveryPatrolPlaceWithTheStation) {
  const TopologicalMap map = Shipped();
  const int station = map.Find("charging_station");
  for (std::size_t i = 0; i < map.places().size(); ++i) {
    const int place = static_cast<int>(i);
    const auto there = map.Route(station, place);
    const auto back = map.Route(place, station);
    ASSERT_TRUE(there && back) << map.places()[i].name;
    if (place == station) continue;
    EXPECT_EQ(map.edges()[there->front()].action, EdgeAction::kUndock);
    EXPECT_EQ(map.edges()[back->back()].action, EdgeAction::kDock);
  }
}

TEST(TopologicalMap, FindsTheNearestPlace) {
  const TopologicalMap map = Shipped();
  EXPECT_EQ(map.places()[map.Nearest({37, 0.5, 0})].name, "corridor_east");
  EXPECT_EQ(map.places()[map.Nearest({-2.3, 0, 0})].name, "charging_station");
}

TEST(TopologicalMap, ChoosesEveryPatrolPlaceButNeverTheLastOne) {
  const TopologicalMap map = Shipped();
  std::mt19937 random(1);
  std::map<int, int> count;
  int last = -1;
  for (int i = 0; i < 800; ++i) {
    const int next = map.ChooseNext(random, last);
    ASSERT_NE(next, last);
    EXPECT_EQ(map.places()[next].category, "patrol");
    ++count[next];
    last = next;
  }
  EXPECT_EQ(count.size(), 8u);
  for (const auto& [place, times] : count) EXPECT_NEAR(times, 100, 40) << place;
}

TEST(TopologicalMap, TheSameSeedGivesTheSamePatrol) {
  const TopologicalMap map = Shipped();
  std::mt19937 a(7);
  std::mt19937 b(7);
  int last = -1;
  for (int i = 0; i < 20; ++i) {
    const int next = map.ChooseNext(a, last);
    EXPECT_EQ(map.ChooseNext(b, last), next);
    last = next;
  }
}

TEST(TopologicalMap, TheOnlyPlaceOfACategoryIsChosenAgain) {
  const TopologicalMap map = Shipped();
  std::mt19937 random(1);
  const int station = map.Find("charging_station");
  EXPECT_EQ(map.ChooseNext(random, station, "station"), station);
  EXPECT_EQ(map.ChooseNext(random, -1, "pool"), -1);
}

TEST(TopologicalMap, NamesTheLineOfEveryMistake) {
  const std::string errors = ErrorsOf(
      "waypoints:\n"
      "  - {name: hall, x: 1, y: 2}\n"
      "  - {name: hall, x: 1, y: 2}\n"
      "  - {name: door, x: here, y: 2}\n"
      "  - {name: room, x: 1, y: 2, jaw: 3}\n"
      "  - {name: lift, x: 1}\n"
      "edges:\n"
      "  - {from: hall, to: dor}\n"
      "  - {from: hall, to: door, action: fly}\n"
      "  - {from: hall, to: door, action: dock, both_ways: true}\n");
  EXPECT_THAT(errors, HasSubstr(".yaml:3"));
  EXPECT_THAT(errors, HasSubstr("\"hall\" is already taken"));
  EXPECT_THAT(errors, HasSubstr(".yaml:4"));
  EXPECT_THAT(errors, HasSubstr(".yaml:5"));
  EXPECT_THAT(errors, HasSubstr("jaw"));
  EXPECT_THAT(errors, HasSubstr(".yaml:6"));
  EXPECT_THAT(errors, HasSubstr("missing key \"y\""));
  EXPECT_THAT(errors, HasSubstr(".yaml:8"));
  EXPECT_THAT(errors, HasSubstr("did you mean \"door\"?"));
  EXPECT_THAT(errors, HasSubstr(".yaml:9"));
  EXPECT_THAT(errors, HasSubstr(".yaml:10"));
}

TEST(TopologicalMap, AFileThatIsMissingOrEmptyIsAnError) {
  Diagnostics diagnostics;
  EXPECT_FALSE(TopologicalMap::Load("/no/such/file.yaml", diagnostics));
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("/no/such/file.yaml"));
  EXPECT_THAT(ErrorsOf("waypoints: []\n"), HasSubstr("no waypoints"));
}

TEST(TopologicalMap, ThereIsNoRouteWhereNoEdgeLeads) {
  Diagnostics diagnostics;
  const auto map = TopologicalMap::Load(Write("waypoints:\n"
                                              "  - {name: a, x: 0, y: 0}\n"
                                              "  - {name: b, x: 1, y: 0}\n"
                                              "edges:\n"
                                              "  - {from: a, to: b}\n"),
                                        diagnostics);
  ASSERT_TRUE(map) << diagnostics.ToString();
  EXPECT_EQ(map->Route(0, 1)->size(), 1u);
  EXPECT_FALSE(map->Route(1, 0));
  EXPECT_TRUE(map->Route(1, 1)->empty());
}

}  // namespace
}  // namespace coppice::robot::navigation
