// The localization of the simulated robot: what it is for, in simulated time.
#include "robot_app/localization/localizer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>

#include "robot_app/common/places/topological_map.h"
#include "robot_app/navigation/navigation.h"
#include "tests/robot_app/localization/localized_robot.h"
#include "tests/support/folders.h"

namespace coppice::robot::localization {
namespace {

using navigation::MapOf;
using testing::HasSubstr;

constexpr Pose2D kAtDock{-2.4, 0, M_PI};

class LocalizerTest : public testing::Test {
 protected:
  // On the floor with its people, known to stand where it stands.
  std::unique_ptr<LocalizedRobot> Started(const Pose2D& pose, std::uint64_t seed = 1) const {
    auto robot = std::make_unique<LocalizedRobot>(floor_, pose, seed);
    robot->localizer().Expect({pose});
    robot->Drive({}, 1);
    EXPECT_TRUE(robot->IsOk());
    return robot;
  }

  simulation::Floor floor_ = navigation::InstituteFloor();
};

struct Errors {
  double mean = 0;
  double worst = 0;
  double worst_yaw = 0;
  double lowest_score = 1;
  int not_ok = 0;
};

// Lets navigation, which is told the truth, drive to places at random.
Errors Patrol(LocalizedRobot& robot, const simulation::Floor& floor, double seconds,
              unsigned seed) {
  Diagnostics diagnostics;
  const auto map = TopologicalMap::Load(
      SourceFolder() + "/robot_app/config/sites/institute/places.yaml", diagnostics);
  navigation::Navigation navigation;
  navigation.SetMap(MapOf(floor));
  std::mt19937 random(seed);
  std::vector<Pose2D> goals;
  for (const Place& place : map->places()) {
    if (place.Is("patrol") || place.Is("approach") || place.Is("station")) {
      goals.push_back(*place.pose);
    }
  }
  const auto next = [&] { return goals[random() % goals.size()]; };
  navigation.SetGoal(next(), robot.now());
  double scan_time = -1;
  Errors errors;
  int count = 0;
  for (const double stop = robot.now() + seconds; robot.now() < stop; ++count) {
    if (robot.world().scan().time != scan_time) {
      scan_time = robot.world().scan().time;
      navigation.AddScan(robot.Truth(), navigation::ScanOf(robot.world()));
    }
    const Velocity2D velocity = navigation.Update(robot.now(), robot.Truth(), robot.now());
    if (navigation.end() != navigation::Navigation::End::kNone)
      navigation.SetGoal(next(), robot.now());
    for (int i = 0; i < 2; ++i) robot.Step(velocity);
    errors.mean += robot.Error();
    errors.worst = std::max(errors.worst, robot.Error());
    errors.worst_yaw = std::max(errors.worst_yaw, robot.YawError());
    errors.lowest_score = std::min(errors.lowest_score, robot.Report().score);
    if (!robot.IsOk()) ++errors.not_ok;
  }
  errors.mean /= count;
  return errors;
}

// Seen from -3.2 m to 10 m of the corridor, in cells of 0.1 m, and turned by half a degree: what a
// short round makes of it.
OccupancyGrid WestEndNotQuiteStraight(const OccupancyGrid& floor) {
  OccupancyGrid map;
  map.frame = {0.1, -3.2, -1.6, 132, 32};
  map.cells.assign(static_cast<std::size_t>(map.frame.size()), 0);
  const double turned = 0.009;
  for (int i = 0; i < floor.frame.size(); ++i) {
    if (floor.cells[i] < OccupancyGrid::kOccupied) continue;
    const Point2D wall = floor.frame.Center(floor.frame.CellOf(i));
    const Point2D there = PointComposer({0, 0, turned})(wall);
    const Cell cell = map.frame.CellAt(there.x, there.y);
    if (map.frame.Contains(cell)) map.cells[map.frame.Index(cell)] = 100;
  }
  return map;
}

TEST_F(LocalizerTest, AlongACorridorWallsThatAreNotQuiteStraightOnTheMapDoNotDrawItAlong) {
  LocalizedRobot robot(floor_, {-0.7, 0, M_PI}, 1);
  robot.localizer().SetMap(WestEndNotQuiteStraight(MapOf(floor_)));
  robot.Drive({}, 8);
  ASSERT_LT(robot.Error(), 0.1);
  double worst = 0;
  const auto look = [&] { return worst = std::max(worst, robot.Error()), false; };
  robot.DriveUntil({0, -0.8}, M_PI / 0.8, look);
  robot.DriveUntil({0.4, 0}, 3, look);
  robot.DriveUntil({}, 3, look);
  EXPECT_LT(worst, 0.15);
}

TEST_F(LocalizerTest, FollowsAPatrolAmongPeople) {
  for (unsigned seed = 1; seed <= 2; ++seed) {
    const auto robot = Started(kAtDock, seed);
    robot->Drive({-0.15, 0}, 11);  // off the station
    const Errors errors = Patrol(*robot, floor_, 200, seed);
    std::cout << "mean " << errors.mean << " m, worst " << errors.worst << " m, "
              << errors.worst_yaw << " rad, lowest score " << errors.lowest_score << "\n";
    EXPECT_LT(errors.worst, 0.15);
    EXPECT_LT(errors.worst_yaw, 0.1);
    EXPECT_LT(errors.mean, 0.02);
    EXPECT_EQ(errors.not_ok, 0);
  }
}

TEST_F(LocalizerTest, IsNotLostBehindACrowdOrBeforeABlockedCorridor) {
  floor_.people.clear();
  for (int i = 0; i < 6; ++i) {  // they walk about the robot
    const double y = -0.9 + 0.36 * i;
    floor_.people.push_back(
        {"p" + std::to_string(i), 0.8, {{13 + 1.5 * i, y}, {18.0 - 0.5 * i, -y}}});
  }
  const auto robot = Started({11, 0, 0});
  while (!robot->world().SetPlaceBlocked("corridor_middle", true)) robot->Step({});
  double lowest = 1;
  EXPECT_EQ(robot->DriveUntil({0.3, 0}, 60,
                              [&] {
                                lowest = std::min(lowest, robot->Report().score);
                                return robot->IsLost();
                              }),
            -1);
  EXPECT_LT(lowest, 0.97);
  EXPECT_TRUE(robot->IsOk());
  EXPECT_LT(robot->Error(), 0.15);
}

TEST_F(LocalizerTest, ACarriedRobotIsLostAndFindsItselfByATurn) {
  const std::vector<Pose2D> before = RandomPoses(MapOf(floor_), 40, 11);
  const std::vector<Pose2D> after = RandomPoses(MapOf(floor_), 40, 12);
  int kidnaps = 0, found = 0, open = 0, open_found = 0;
  double longest = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (IsSamePlace(before[i], after[i])) continue;
    const auto robot = Started(before[i], 10 * i + 1);
    robot->Carry(after[i]);
    const double lost = robot->DriveUntil({}, 10, [&] { return robot->IsLost(); });
    EXPECT_GE(lost, 0) << i;
    longest = std::max(longest, lost);
    robot->TurnOnce();
    robot->Drive({}, 2);
    const bool in_office = after[i].x < 36 && std::abs(after[i].y) > 1.25;
    ++kidnaps;
    if (!in_office) ++open;
    if (!robot->IsOk()) {  // several places fit: then it says so
      EXPECT_EQ(robot->Report().phase, LocalizationPhase::kUncertain) << i;
      EXPECT_THAT(robot->Report().message, HasSubstr("places on the map fit")) << i;
      continue;
    }
    EXPECT_LT(robot->Error(), 0.1) << i;  // never a wrong place
    ++found;
    if (!in_office) ++open_found;
  }
  std::cout << found << " of " << kidnaps << " found, in corridor and hall " << open_found << " of "
            << open << "; lost after at most " << longest << " s\n";
  EXPECT_GE(found, kidnaps / 2);
  EXPECT_GE(open_found, open * 3 / 4);
}

// Walls at both sides look the same everywhere, and all doors look alike.
class CarriedAlongTheCorridor : public LocalizerTest,
                                public testing::WithParamInterface<Velocity2D> {};

TEST_P(CarriedAlongTheCorridor, IsLostWithinTenSeconds) {
  int carried = 0, noticed = 0;
  double longest = 0;
  for (double x = 0; x < 36; x += 3) {
    for (const double way : {-5.0, 2.5}) {
      for (const double yaw : {0.0, M_PI}) {
        if (x + way < 0 || x + way > 38) continue;
        const auto robot = Started({x, 0.1, yaw}, 7 * carried + 1);
        robot->Drive(GetParam(), 2);
        const Pose2D stood = robot->Truth();
        robot->Carry({stood.x + way, -0.1, stood.yaw});
        const double lost = robot->DriveUntil(GetParam(), 10, [&] { return robot->IsLost(); });
        ++carried;
        if (lost >= 0) ++noticed;
        longest = std::max(longest, lost);
      }
    }
  }
  std::cout << noticed << " of " << carried << " noticed, after at most " << longest << " s\n";
  EXPECT_GE(noticed, carried * 95 / 100);
}

INSTANTIATE_TEST_SUITE_P(StandingTurningDriving, CarriedAlongTheCorridor,
                         testing::Values(Velocity2D{0, 0}, Velocity2D{0, 0.4}, Velocity2D{0.3, 0}));

TEST_F(LocalizerTest, SaysThatSeveralPlacesFitUntilAPersonHelps) {
  const auto robot = Started({46, 0, 0});
  robot->Carry({32, 5, 1});  // office 104 looks like 101
  robot->Drive({}, 8);
  robot->TurnOnce();
  EXPECT_EQ(robot->Report().phase, LocalizationPhase::kUncertain);
  EXPECT_THAT(robot->Report().message, HasSubstr("2 places on the map fit"));
  robot->localizer().SetPose(Compose(robot->Truth(), {0.3, -0.2, 0.1}), 0.5, 0.2);
  robot->Drive({}, 2);
  EXPECT_TRUE(robot->IsOk()) << robot->Report().message;
  EXPECT_LT(robot->Error(), 0.1);
}

TEST_F(LocalizerTest, FindsOutByDrivingToAPlaceThatIsUnique) {
  const auto robot = Started({46, 0, 0});
  robot->Carry({32, 3.5, -M_PI / 2});
  robot->Drive({}, 8);
  robot->TurnOnce();
  EXPECT_FALSE(robot->IsOk());
  const double seconds = robot->DriveUntil({0.4, 0}, 9, [&] { return robot->IsOk(); });
  robot->Drive({0, 0.4}, seconds < 0 ? 8 : 0);  // at the door: along the corridor
  EXPECT_TRUE(robot->IsOk()) << robot->Report().message;
  EXPECT_LT(robot->Error(), 0.1);
}

TEST_F(LocalizerTest, StartsAtTheStationIfItStandsThere) {
  LocalizedRobot robot(floor_, kAtDock, 1);
  robot.localizer().Expect({{20, 0, 0}, Compose(kAtDock, {0.1, 0.05, 0.05})});
  EXPECT_FALSE(robot.localizer().pose());
  EXPECT_FALSE(robot.IsOk());
  robot.Drive({}, 1);
  EXPECT_TRUE(robot.IsOk());
  EXPECT_LT(robot.Error(), 0.02);
}

TEST_F(LocalizerTest, StartsWhereItIsExpectedThoughPlacesNearbyFitAsWell) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const auto robot = Started({2, 0, 0}, seed);  // bare walls on both sides
    EXPECT_LT(robot->Error(), 0.1) << seed;
  }
}

TEST_F(LocalizerTest, ACrowdInTheCorridorIsNoReasonToDoubt) {
  for (int i = 0; i < 6; ++i) {
    const double y = -0.9 + 0.36 * i;
    floor_.people.push_back({"p" + std::to_string(i), 0.6 + 0.15 * i, {{5.0 * i, y}, {36, -y}}});
  }
  const auto robot = Started({2, 0, 0}, 5);
  const Errors errors = Patrol(*robot, floor_, 120, 5);
  EXPECT_EQ(errors.not_ok, 0);
  EXPECT_LT(errors.worst, 0.15);
}

TEST_F(LocalizerTest, DoesNotBelieveAStartThatIsWrong) {
  LocalizedRobot robot(floor_, {24, 0, 0.5}, 1);
  robot.localizer().Expect({kAtDock});
  robot.Drive({}, 3);
  EXPECT_FALSE(robot.IsOk());
  robot.Drive({}, 3);
  EXPECT_TRUE(robot.IsLost());
  robot.TurnOnce();
  EXPECT_TRUE(robot.IsOk()) << robot.Report().message;
  EXPECT_LT(robot.Error(), 0.1);
}

TEST_F(LocalizerTest, GoesOnWhenTheOdometryIsRestarted) {
  const auto robot = Started({20, 0, 0});
  robot->Drive({0.5, 0.3}, 5);
  robot->RestartOdometry();
  robot->Drive({}, 0.3);
  EXPECT_TRUE(robot->IsOk());
  EXPECT_LT(robot->Error(), 0.15);
  robot->Drive({-0.1, 0.3}, 5);
  EXPECT_TRUE(robot->IsOk());
  EXPECT_LT(robot->Error(), 0.05);
}

TEST_F(LocalizerTest, ForgetsEverythingOnRequest) {
  const auto robot = Started({46, 0, 0});
  robot->localizer().Relocalize();
  EXPECT_FALSE(robot->localizer().pose());
  robot->Drive({}, 1);
  EXPECT_FALSE(robot->IsOk());
  robot->TurnOnce();
  EXPECT_TRUE(robot->IsOk());
}

TEST_F(LocalizerTest, APersonMayBeWrong) {
  const auto robot = Started({46, 0, 0});
  robot->localizer().SetPose({20, 0, 0}, 0.5, 0.2);
  robot->Drive({}, 8);
  EXPECT_TRUE(robot->IsLost());
}

TEST_F(LocalizerTest, BeginsAnewWhenTimeIsSetBack) {
  Localizer localizer;
  localizer.SetMap(MapOf(floor_));
  localizer.Expect({kAtDock});
  const auto see = [&](const Pose2D& pose, double stamp) {
    simulation::WorldOptions options;
    options.start = simulation::Pose2{pose.x, pose.y, pose.yaw};
    LaserScan scan = navigation::ScanOf(simulation::World(floor_, options));
    scan.stamp = stamp;
    localizer.AddOdometry(stamp, {});
    localizer.AddScan(scan);
    return localizer.Report(stamp).phase;
  };
  EXPECT_EQ(see(kAtDock, 100), LocalizationPhase::kOk);
  localizer.SetPose({46, 0, 0}, 0.1, 0.1);
  EXPECT_EQ(see({46, 0, 0}, 101), LocalizationPhase::kOk);
  EXPECT_EQ(see(kAtDock, 5), LocalizationPhase::kOk);
  EXPECT_NEAR(localizer.pose()->x, kAtDock.x, 0.02);
}

TEST_F(LocalizerTest, IsUncertainWithoutScansButNotLost) {
  const auto robot = Started({46, 0, 0});
  const double now = robot->now();
  EXPECT_EQ(robot->localizer().Report(now + 3).phase, LocalizationPhase::kUncertain);
  const LocalizationReport later = robot->localizer().Report(now + 6);
  EXPECT_EQ(later.phase, LocalizationPhase::kUncertain);
  EXPECT_NEAR(later.seconds_since_confirmed, 6, 0.2);
  EXPECT_THAT(later.message, HasSubstr("no scan"));
}

TEST_F(LocalizerTest, WaitsForOdometryAndMap) {
  Localizer localizer;
  EXPECT_THAT(localizer.Report(0).message, HasSubstr("map"));
  LaserScan scan;
  scan.stamp = 10;
  scan.ranges.assign(541, 3);
  localizer.AddScan(scan);
  localizer.SetMap(MapOf(floor_));
  localizer.AddScan(scan);
  EXPECT_THAT(localizer.Report(10).message, HasSubstr("scan"));
  localizer.AddOdometry(9.9, {});
  EXPECT_EQ(localizer.scan_stamp(), 0);
  localizer.AddOdometry(10.1, {});
  EXPECT_EQ(localizer.scan_stamp(), 10);
  scan.stamp = NAN;
  localizer.AddScan(scan);
  scan.stamp = 10.05;
  scan.ranges.assign(541, NAN);
  localizer.AddScan(scan);
  EXPECT_EQ(localizer.scan_stamp(), 10.05);
  EXPECT_NE(localizer.Report(10.1).phase, LocalizationPhase::kOk);
}

}  // namespace
}  // namespace coppice::robot::localization
