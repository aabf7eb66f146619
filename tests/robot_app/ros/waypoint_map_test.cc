#include "robot_app/ros/waypoint_map.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <stdexcept>

#include "tests/support/folders.h"

namespace coppice::robot::adapters {
namespace {

using leaves::WaypointMap;

const std::string kShipped = SourceFolder() + "/robot_app/config/waypoints.yaml";

TEST(WaypointMap, FindsThePlaceInFrontOfTheStation) {
  leaves::Waypoint waypoint;
  ASSERT_TRUE(LoadWaypointMap(kShipped, 1)->Find("staging", waypoint));
  EXPECT_DOUBLE_EQ(waypoint.pose.x, -0.8);
}

TEST(WaypointMap, KnowsNoOtherNames) {
  leaves::Waypoint waypoint;
  EXPECT_FALSE(LoadWaypointMap(kShipped, 1)->Find("cellar", waypoint));
}

TEST(WaypointMap, NeverChoosesTheSamePlaceTwiceInARow) {
  const auto map = LoadWaypointMap(kShipped, 1);
  std::string last;
  for (int i = 0; i < 200; ++i) {
    const std::string name = map->ChooseForPatrol().name;
    EXPECT_NE(name, last);
    last = name;
  }
}

TEST(WaypointMap, ChoosesEveryPlaceOfThePatrolSometime) {
  const auto map = LoadWaypointMap(kShipped, 1);
  std::set<std::string> chosen;
  for (int i = 0; i < 200; ++i) chosen.insert(map->ChooseForPatrol().name);
  EXPECT_EQ(chosen.size(), 8u);
}

TEST(WaypointMap, GivesTheSameOrderForTheSameSeed) {
  const auto a = LoadWaypointMap(kShipped, 5);
  const auto b = LoadWaypointMap(kShipped, 5);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(a->ChooseForPatrol().name, b->ChooseForPatrol().name);
}

TEST(WaypointMap, RefusesAFileWithoutPatrol) {
  const std::string path = testing::TempDir() + "waypoint_map_test.yaml";
  std::ofstream(path) << "waypoints:\n  - {name: a, x: 0, y: 0, yaw: 0, category: office}\n";
  EXPECT_THROW(LoadWaypointMap(path, 1), std::runtime_error);
}

}  // namespace
}  // namespace coppice::robot::adapters
