#include "robot_app/simulation/floor.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "robot_app/common/places/topological_map.h"
#include "robot_app/simulation/world.h"
#include "tests/robot_app/simulation/test_floor.h"

namespace coppice::robot::simulation {
namespace {

using testing::HasSubstr;

constexpr char kStation[] = "charging_station: {docked: [0, 0, 0], staging: [1, 0, 0]}\n";
constexpr char kSmall[] =
    "name: small\n"
    "wall_height: 2.5\n"
    "walls: [[[0, 0], [4, 0]]]\n";

// The messages for a floor whose fourth line is `line`.
std::string ErrorsOf(const std::string& line) {
  Diagnostics diagnostics;
  const auto floor =
      ParseFloor(std::string(kSmall) + line + "\n" + kStation, "f.yaml", diagnostics);
  EXPECT_EQ(floor.has_value(), !diagnostics.has_errors());
  return diagnostics.ToString();
}

TEST(Floor, ReadsTheInstitute) {
  const Floor floor = LoadInstitute();
  EXPECT_EQ(floor.name, "institute");
  EXPECT_EQ(floor.doors.size(), 8U);
  EXPECT_GE(floor.places.size(), 2U);
  EXPECT_GE(floor.people.size(), 3U);
  EXPECT_NEAR(floor.docked.x, -2.4, 1e-9);
  EXPECT_NEAR(std::abs(floor.docked.yaw), kPi, 1e-9);
  for (const Door& door : floor.doors) {
    EXPECT_GE(Length(door.end - door.hinge), 1.0) << door.name;
  }
}

TEST(Floor, ReadsEveryKindOfThing) {
  EXPECT_EQ(ErrorsOf("places: [{name: p, at: [1, 1], size: [1, 2], yaw: 0.5, height: 1}]"), "");
  EXPECT_EQ(ErrorsOf("people: [{name: a, speed: 1, path: [[0, 0], [1, 1]]}]"), "");
  EXPECT_EQ(ErrorsOf("people: [{name: a, speed: 1, height: 1.6, path: [[0, 0], [1, 1]]}]"), "");
  EXPECT_EQ(ErrorsOf("waypoints: [{name: w, pose: [1, 2, 3]}]"), "");
  EXPECT_EQ(ErrorsOf("furniture: [{name: f, at: [1, 1], size: [1, 2], height: 2, poster: yes}]"),
            "");
  EXPECT_EQ(ErrorsOf("glass: [[[0, 0], [4, 0]]]"), "");
  EXPECT_EQ(ErrorsOf("doors: [{name: d, kind: sliding, hinge: [0, 0], end: [1, 0], state: open}]"),
            "");
}

TEST(Floor, WithoutAStationItSaysWhereTheRobotBegins) {
  Diagnostics diagnostics;
  const auto floor =
      ParseFloor(std::string(kSmall) + "start: [1, 2, 0.5]\n", "f.yaml", diagnostics);
  ASSERT_TRUE(floor) << diagnostics.ToString();
  EXPECT_FALSE(floor->has_station);
  EXPECT_EQ(floor->docked.x, 1);
}

TEST(Floor, SaysEitherWhereTheStationIsOrWhereTheRobotBegins) {
  EXPECT_THAT(ErrorsOf("start: [1, 2, 0.5]"), HasSubstr("f.yaml:4:8"));
}

TEST(Floor, EveryShippedSiteHasAWorldInWhichTheRobotCanStandAtItsPlaces) {
  for (const auto& site :
       std::filesystem::directory_iterator(SourceFolder() + "/robot_app/config/sites")) {
    Diagnostics diagnostics;
    const auto floor = LoadFloor((site.path() / "world.yaml").string(), diagnostics);
    const auto map = TopologicalMap::Load((site.path() / "places.yaml").string(), diagnostics);
    ASSERT_TRUE(floor && map) << diagnostics.ToString();
    EXPECT_EQ(floor->name, site.path().filename());
    EXPECT_EQ(map->site(), floor->name);
    EXPECT_EQ(map->FirstOf("station") >= 0, floor->has_station);
    World world(*floor);
    for (const Place& place : map->places()) {
      if (!place.pose || place.Is("station")) continue;
      EXPECT_TRUE(world.Kidnap({place.pose->x, place.pose->y, place.pose->yaw}))
          << floor->name << ": " << place.name;
    }
  }
}

TEST(Floor, TheLandmarkOfTheInstituteIsTheOneThatTheRobotLooksFor) {
  const Floor floor = LoadInstitute();
  ASSERT_TRUE(floor.landmark);
  EXPECT_DOUBLE_EQ(floor.landmark->shape.leg, LandmarkShape().leg);
  EXPECT_DOUBLE_EQ(floor.landmark->shape.opening, LandmarkShape().opening);
  EXPECT_DOUBLE_EQ(floor.landmark->shape.ahead, LandmarkShape().ahead);
}

TEST(Floor, TheCornerOfTheLandmarkPointsToTheDockedRobot) {
  const Triangle triangle = LandmarkAt({0.5, kPi / 2, 0.4}, {1, 2, kPi / 2});
  const double reach = 0.5 * std::sqrt(0.5);
  EXPECT_NEAR(triangle[0].x, 1, 1e-12);
  EXPECT_NEAR(triangle[0].y, 2.4, 1e-12);
  EXPECT_NEAR(triangle[1].x, 1 - reach, 1e-12) << "left";
  EXPECT_NEAR(triangle[1].y, 2.4 + reach, 1e-12);
  EXPECT_NEAR(triangle[2].x, 1 + reach, 1e-12) << "right";
}

TEST(Floor, TellsWhatIsWrongWithALandmark) {
  Diagnostics diagnostics;
  ParseFloor(std::string(kSmall) +
                 "charging_station: {docked: [0, 0, 0], staging: [1, 0, 0], landmark: "
                 "{leg: 0.3, opening: 4, height: 1}}",
             "f.yaml", diagnostics);
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("opening must be less than pi"));
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("\"ahead\" is missing"));
}

TEST(Floor, TellsTheLineOfAMistake) {
  EXPECT_THAT(ErrorsOf("places: [{name: p, at: [1, x], size: [1, 2], height: 1}]"),
              HasSubstr("f.yaml:4:28: error: place: at: expected a number"));
  EXPECT_THAT(ErrorsOf("people: [{name: a, speed: 0, path: [[0, 0], [1, 1]]}]"),
              HasSubstr("f.yaml:4:27: error: person: speed must be greater than 0"));
  EXPECT_THAT(ErrorsOf("people: [{name: a, speed: 1, mask: maybe, path: [[0, 0], [1, 1]]}]"),
              HasSubstr("person: mask must be yes or no"));
  EXPECT_THAT(ErrorsOf("people: [{name: a, speed: 1, steps_aside: 1, path: [[0, 0], [1, 1]]}]"),
              HasSubstr("person: steps_aside must be yes or no"));
  EXPECT_THAT(ErrorsOf("people: [{name: a, speed: 1, height: -1, path: [[0, 0], [1, 1]]}]"),
              HasSubstr("person: height must be greater than 0"));
  EXPECT_THAT(ErrorsOf("people: [{name: a, speed: 1, path: [[0, 0]]}]"),
              HasSubstr("at least two points"));
  EXPECT_THAT(ErrorsOf("waypoints: [{name: w, pose: [1, 2]}]"),
              HasSubstr("waypoint: pose: expected a list of 3 numbers"));
  EXPECT_THAT(ErrorsOf("waypoints: 7"),
              HasSubstr("f.yaml:4:12: error: waypoints: expected a list"));
}

TEST(Floor, IsNoLargerThanThereIsMemoryFor) {
  EXPECT_EQ(ErrorsOf("waypoints: [{name: w, pose: [-100, 100, 1]}]"), "");
  for (const char* const far : {"101", "-1e9", "1e308"}) {
    EXPECT_THAT(
        ErrorsOf("waypoints: [{name: w, pose: [" + std::string(far) + ", 0, 0]}]"),
        HasSubstr("f.yaml:4:30: error: waypoint: pose: expected a number from -100 to 100"));
  }
}

TEST(Floor, SuggestsTheRightWordForAMisspeltKey) {
  EXPECT_THAT(ErrorsOf("dors: []"), HasSubstr(R"(unknown key "dors" (did you mean "doors"?))"));
  EXPECT_THAT(ErrorsOf("doors: [{name: d, kind: hinged, hinge: [0, 0], end: [1, 0], swing: up, "
                       "state: open}]"),
              HasSubstr(R"(swing must be left or right, not "up")"));
}

TEST(Floor, TellsWhatIsMissing) {
  EXPECT_THAT(ErrorsOf("places: [{name: p, at: [1, 1], height: 1}]"),
              HasSubstr(R"(f.yaml:4:10: error: place: "size" is missing)"));
  Diagnostics diagnostics;
  EXPECT_FALSE(ParseFloor("name: x\n", "f.yaml", diagnostics));
  EXPECT_THAT(diagnostics.ToString(), HasSubstr(R"("charging_station" is missing)"));
}

TEST(Floor, RefusesTheSameNameTwice) {
  EXPECT_THAT(ErrorsOf("waypoints: [{name: w, pose: [1, 2, 3]}, {name: w, pose: [1, 2, 3]}]"),
              HasSubstr(R"(the name "w" is used twice)"));
  EXPECT_THAT(ErrorsOf("name: again"), HasSubstr("appears twice"));
}

TEST(Floor, ReportsTextThatIsNotYaml) {
  EXPECT_THAT(ErrorsOf("doors: [}"), HasSubstr("f.yaml:4"));
  EXPECT_THAT(ErrorsOf("[1, 2]: 3"), HasSubstr("error"));
  Diagnostics diagnostics;
  EXPECT_FALSE(ParseFloor("just words", "f.yaml", diagnostics));
  EXPECT_FALSE(ParseFloor("", "f.yaml", diagnostics));
}

TEST(Floor, ReportsAFileThatCannotBeRead) {
  Diagnostics diagnostics;
  EXPECT_FALSE(LoadFloor("/nowhere/f.yaml", diagnostics));
  EXPECT_FALSE(LoadFloor("/dev/zero", diagnostics));  // is not read for ever
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("/nowhere/f.yaml: error: cannot be read"));
}

TEST(Floor, AnOpenLeafStandsInTheRoom) {
  Door door;
  door.hinge = {1, 0};
  door.end = {2, 0};
  EXPECT_EQ(DoorLeaf(door, false)->b.x, 2);
  EXPECT_NEAR(DoorLeaf(door, true)->b.y, 1, 1e-12);
  door.swings_left = false;
  EXPECT_NEAR(DoorLeaf(door, true)->b.y, -1, 1e-12);
  door.kind = Door::Kind::kSliding;
  EXPECT_FALSE(DoorLeaf(door, true));
  EXPECT_TRUE(DoorLeaf(door, false));
}

TEST(Floor, TheLeafOfAHingedDoorSweepsAQuarterOfADisc) {
  Door door;
  door.end = {2, 0};
  EXPECT_EQ(DistanceFromSweep(door, {1, 1}), 0);
  EXPECT_NEAR(DistanceFromSweep(door, {2, 2}), std::sqrt(8) - 2, 1e-12);
  EXPECT_NEAR(DistanceFromSweep(door, {1, -0.5}), 0.5, 1e-12);
  EXPECT_NEAR(DistanceFromSweep(door, {-0.4, 1}), 0.4, 1e-12);
  door.kind = Door::Kind::kSliding;
  EXPECT_NEAR(DistanceFromSweep(door, {1, 1}), 1, 1e-12);
}

}  // namespace
}  // namespace coppice::robot::simulation
