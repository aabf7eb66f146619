#include "robot_app/common/places/route.h"

#include <gtest/gtest.h>

#include "tests/robot_app/common/places/sample_map.h"

namespace coppice::robot {
namespace {

std::string Way(const TopologicalMap& map, const Route& route) {
  std::string text = map.places()[static_cast<std::size_t>(route.start)].name;
  for (const int edge : route.edges) {
    text +=
        " " +
        map.places()[static_cast<std::size_t>(map.edges()[static_cast<std::size_t>(edge)].to)].name;
  }
  return text;
}

TEST(FindRoute, TakesTheCheapestWay) {
  const TopologicalMap map = SampleMap();
  std::vector<double> costs = ExpectedCosts(map);
  const std::vector<RouteStart> start{{map.Find("west"), 0}};
  EXPECT_EQ(Way(map, *FindRoute(map, start, map.Find("east"), costs)), "west middle east");
  costs[static_cast<std::size_t>(map.FindEdge(map.Find("west"), map.Find("middle")))] = 1000;
  EXPECT_EQ(Way(map, *FindRoute(map, start, map.Find("east"), costs)), "west yard east");
}

TEST(FindRoute, BeginsWhereItIsCheapestWithTheWayToThere) {
  const TopologicalMap map = SampleMap();
  const std::vector<double> costs = ExpectedCosts(map);
  const auto route =
      FindRoute(map, {{map.Find("west"), 0}, {map.Find("east"), 5}}, map.Find("east"), costs);
  EXPECT_EQ(Way(map, *route), "east");
  EXPECT_DOUBLE_EQ(route->cost, 5);
}

TEST(FindRoute, ThereIsNoneWhereNoEdgeLeads) {
  const TopologicalMap map = SampleMap();
  const std::vector<double> costs = ExpectedCosts(map);
  EXPECT_FALSE(FindRoute(map, {{map.Find("west"), 0}}, map.Find("island"), costs));
  EXPECT_FALSE(FindRoute(map, {{map.Find("attic"), 0}}, map.Find("west"), costs));
  EXPECT_FALSE(FindRoute(map, {}, map.Find("west"), costs));
}

TEST(FindRoute, JoinsEveryPlaceOfTheShippedMapWithTheStation) {
  const TopologicalMap map = ShippedMap();
  const std::vector<double> costs = ExpectedCosts(map);
  const int station = map.FirstOf("station");
  for (int place = 0; place < static_cast<int>(map.places().size()); ++place) {
    if (place == station) continue;
    const std::string& name = map.places()[static_cast<std::size_t>(place)].name;
    const auto there = FindRoute(map, {{station, 0}}, place, costs);
    ASSERT_TRUE(there) << name;
    EXPECT_EQ(map.edges()[static_cast<std::size_t>(there->edges.front())].kind, EdgeKind::kUndock);
    if (!map.places()[static_cast<std::size_t>(place)].pose) continue;
    const auto back = FindRoute(map, {{place, 0}}, station, costs);
    ASSERT_TRUE(back) << name;
    EXPECT_EQ(map.edges()[static_cast<std::size_t>(back->edges.back())].kind, EdgeKind::kDock);
  }
}

}  // namespace
}  // namespace coppice::robot
