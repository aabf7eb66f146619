#include "robot_app/simulation/world.h"

#include <gmock/gmock.h>

#include "tests/robot_app/simulation/test_floor.h"

namespace coppice::robot::simulation {
namespace {

using testing::HasSubstr;

constexpr double kDt = 0.02;

WorldOptions At(double x, double y, double yaw) {
  WorldOptions options;
  options.start = Pose2{x, y, yaw};
  return options;
}

void Drive(World& world, const Velocity& velocity, double seconds) {
  const double end = world.time() + seconds - 1e-9;
  while (world.time() < end) world.Step(kDt, velocity);
}

Floor RoomWithThings() {
  Floor floor = MakeRoom();
  floor.places = {{"middle", {{10, 0}, {0.8, 3.9}, 0}, 1.0}};
  floor.doors.resize(1);
  floor.doors[0].name = "gate";
  floor.doors[0].hinge = {15, -2};
  floor.doors[0].end = {15, 2};
  return floor;
}

TEST(World, DistanceDrivenIsSpeedTimesTime) {
  World world(MakeRoom(), At(2, 0, 0));
  Drive(world, {0.5, 0}, 10);
  // 0.5 m/s after a ramp of 0.6 m/s^2
  EXPECT_NEAR(world.robot().x, 2 + 0.5 * 10 - 0.5 * 0.5 / 0.6 / 2, 0.02);
  EXPECT_NEAR(world.odometry().pose().x, world.robot().x - 2, 0.05);
}

TEST(World, TheCommandTimesOut) {
  World world(MakeRoom(), At(2, 0, 0));
  Drive(world, {0.5, 0}, 2);
  for (int i = 0; i < 100; ++i) world.Step(kDt);
  EXPECT_NEAR(world.velocity().linear, 0, 1e-6);
  EXPECT_LT(world.robot().x, 2 + 0.5 * 2.5 + 0.3);
}

TEST(World, TheLidarStopsTheRobotBeforeAWall) {
  World world(MakeRoom(), At(15, 0, 0));
  for (int i = 0; i < 500; ++i) {
    world.Step(kDt, Velocity{0.9, 0});
    ASSERT_FALSE(world.touching());
  }
  EXPECT_TRUE(world.protective_stop());
  EXPECT_NEAR(world.robot().x, 20 - kRobotRadius - 0.05, 0.03);
}

TEST(World, BackingIntoAWallStopsTheRobotAndForwardIsFree) {
  World world(MakeRoom(), At(3, 0, 0));
  Drive(world, {-0.9, 0}, 6);
  EXPECT_TRUE(world.touching());
  EXPECT_NEAR(world.robot().x, kRobotRadius, 0.02);
  EXPECT_NEAR(world.velocity().linear, 0, 0.02);
  Drive(world, {0.5, 0}, 3);
  EXPECT_FALSE(world.touching());
  EXPECT_GT(world.robot().x, 1);
}

TEST(World, BumpsIntoWhatIsTooLowForTheLidarAndGetsFreeBackwards) {
  Floor floor = MakeRoom();
  floor.furniture = {{"step", {{10, 0}, {0.5, 4}, 0}, 0.1}};
  World world(floor, At(8, 0, 0));
  Drive(world, {0.9, 0}, 5);
  EXPECT_TRUE(world.touching());
  EXPECT_NEAR(world.robot().x, 9.75 - kRobotRadius, 0.02);
  Drive(world, {-0.5, 0}, 3);
  EXPECT_LT(world.robot().x, 8.5);
}

TEST(World, BumpsIntoGlassThatTheLidarDoesNotSee) {
  Floor floor = MakeRoom();
  floor.glass = {{{10, -2}, {10, 2}}};
  World world(floor, At(8, 0, 0));
  Drive(world, {0.9, 0}, 5);
  EXPECT_TRUE(world.touching());
  EXPECT_NEAR(world.robot().x, 10 - kRobotRadius, 0.02);
}

TEST(World, OdometryAndTruthAgreeThroughTheTransform) {
  World world(MakeRoom(), At(5, 0, 0.5));
  Drive(world, {0.3, 0.4}, 8);
  const Pose2 back = Compose(world.OdomInMap(), world.odometry().pose());
  EXPECT_NEAR(back.x, world.robot().x, 1e-9);
  EXPECT_NEAR(back.yaw, world.robot().yaw, 1e-9);
}

TEST(World, SensorsKeepTheirPeriods) {
  World world(MakeRoom(), At(5, 0, 0));
  int scans = 0;
  int readings = 0;
  double scan = world.scan().time;
  double reading = world.odometry().time();
  for (int i = 0; i < 500; ++i) {  // 10 s
    world.Step(kDt);
    scans += world.scan().time != scan;
    readings += world.odometry().time() != reading;
    scan = world.scan().time;
    reading = world.odometry().time();
  }
  EXPECT_NEAR(scans, 100, 1);
  EXPECT_NEAR(readings, 200, 2);
}

TEST(World, ChargesOnlyWhenTheContactsTouch) {
  WorldOptions options;
  options.state_of_charge = 0.5;
  World docked(MakeRoom(), options);
  docked.Step(kDt);
  EXPECT_TRUE(docked.docked());
  EXPECT_TRUE(docked.battery().charging());

  const auto charges = [](double dx, double dy, double dyaw) {
    WorldOptions near = At(0.6 + dx, dy, kPi + dyaw);
    near.state_of_charge = 0.5;
    World world(MakeRoom(), near);
    world.Step(kDt);
    return world.battery().charging();
  };
  EXPECT_TRUE(charges(0.02, 0.02, 0.04));
  EXPECT_FALSE(charges(0.04, 0, 0));
  EXPECT_FALSE(charges(0, -0.04, 0));
  EXPECT_FALSE(charges(0, 0, 0.06));
}

TEST(World, DrivesIntoItsDockAndCharges) {
  const Floor floor = LoadInstitute();
  WorldOptions options = At(floor.staging.x, floor.staging.y, floor.staging.yaw);
  options.state_of_charge = 0.3;
  World world(floor, options);
  while (world.time() < 60 && world.robot().x > floor.docked.x + 0.01) {
    world.Step(kDt, Velocity{0.1, 0});
  }
  Drive(world, {0, 0}, 1);
  EXPECT_TRUE(world.docked());
  EXPECT_TRUE(world.battery().charging());
  Drive(world, {-0.2, 0}, 3);
  EXPECT_FALSE(world.battery().charging());
}

// Where the middle beam of the laser ends, from x on the axis of the station.
double SeenBefore(World& world) {
  world.Step(0.2);
  return world.scan().ranges[world.scan().ranges.size() / 2] + world.lidar().options().mounting.x;
}

TEST(World, TheLaserSeesTheLandmarkAndItsStationMovesWithIt) {
  World world(LoadInstitute(), At(-0.8, 0, kPi));
  const double ahead = LandmarkShape().ahead;
  EXPECT_NEAR(SeenBefore(world), 1.6 + ahead, 0.04);
  ASSERT_TRUE(world.MoveStation({-0.3, 0, 0})) << "towards the robot";
  EXPECT_NEAR(SeenBefore(world), 1.3 + ahead, 0.04);
  ASSERT_TRUE(world.Kidnap({-2.1, 0, kPi}));
  world.Step(kDt);
  EXPECT_TRUE(world.docked());
  ASSERT_TRUE(world.MoveStation({-0.2, 0.45, 0.35}));
  EXPECT_FALSE(world.docked());
  ASSERT_TRUE(world.Kidnap(world.station()));
  world.Step(kDt);
  EXPECT_TRUE(world.docked());
}

TEST(World, AStationWithoutItsLandmarkShowsTheWall) {
  World world(LoadInstitute(), At(-0.8, 0, kPi));
  ASSERT_TRUE(world.SetLandmark(false));
  EXPECT_NEAR(SeenBefore(world), 2.2, 0.04);
  ASSERT_TRUE(world.SetLandmark(true));
  EXPECT_NEAR(SeenBefore(world), 1.6 + LandmarkShape().ahead, 0.04);
}

TEST(World, TheLandmarkStopsTheRobot) {
  World world(LoadInstitute(), At(-2.2, 0, kPi));
  Drive(world, {0.2, 0}, 5);
  EXPECT_GT(world.robot().x, -2.4 - LandmarkShape().ahead + kRobotRadius);
}

TEST(World, AStationIsNotMovedIntoAWallOrTheRobot) {
  World world(LoadInstitute(), At(-1.9, 0, kPi));
  EXPECT_THAT(world.MoveStation({0.2, 0, 0}).problem(), testing::HasSubstr("a wall"));
  EXPECT_THAT(world.MoveStation({-0.1, 0.95, 0}).problem(), testing::HasSubstr("a wall"));
  EXPECT_THAT(world.MoveStation({-0.58, 0, 0}).problem(), testing::HasSubstr("the robot"));
  EXPECT_THAT(world.MoveStation({0, 0, 1}).problem(), testing::HasSubstr("45 degrees"));
  EXPECT_EQ(world.station_moved().x, 0);
}

TEST(World, AnEmptyBatteryStopsTheRobot) {
  World world(MakeRoom(), At(5, 0, 0));
  EXPECT_TRUE(world.SetStateOfCharge(0));
  Drive(world, {0.5, 0}, 2);
  EXPECT_NEAR(world.robot().x, 5, 1e-6);
  EXPECT_FALSE(world.SetStateOfCharge(1.2));
}

TEST(World, ABlockedPlaceIsSolidAndSeenUntilItIsCleared) {
  World world(RoomWithThings(), At(5, 0, 0));
  EXPECT_TRUE(world.SetPlaceBlocked("middle", true));
  Drive(world, {0.9, 0}, 8);
  EXPECT_LT(world.robot().x, 9.6 - kRobotRadius);
  EXPECT_LT(world.scan().ranges[270], 0.3);
  EXPECT_TRUE(world.SetPlaceBlocked("middle", false));
  Drive(world, {0.9, 0}, 5);
  EXPECT_GT(world.robot().x, 11);
}

TEST(World, NeverPutsABoxOnTheRobotOrAPerson) {
  Floor floor = RoomWithThings();
  World on_robot(floor, At(10.5, 0, 0));
  const Change refused = on_robot.SetPlaceBlocked("middle", true);
  EXPECT_FALSE(refused);
  EXPECT_THAT(refused.problem(), HasSubstr("the robot stands there"));
  EXPECT_FALSE(on_robot.place_blocked()[0]);

  floor.people = {{"anna", 1.0, {{10, 1}, {12, 1}}}};
  World on_person(floor, At(5, 0, 0));
  EXPECT_THAT(on_person.SetPlaceBlocked("middle", true).problem(), HasSubstr("anna stands there"));
}

TEST(World, DoorsCloseAndOpenButNotOnTheRobot) {
  World world(RoomWithThings(), At(10, 0, 0));
  EXPECT_TRUE(world.door_open()[0]);
  EXPECT_TRUE(world.SetDoorOpen("gate", false));
  Drive(world, {0.9, 0}, 8);
  EXPECT_LT(world.robot().x, 15 - kRobotRadius);
  const Change refused = world.SetDoorOpen("gate", true);  // it would swing over the robot
  EXPECT_FALSE(refused);
  EXPECT_THAT(refused.problem(), HasSubstr("cannot open gate: the robot stands in the way"));
  Drive(world, {-0.9, 0}, 6);
  EXPECT_TRUE(world.SetDoorOpen("gate", true));
  Drive(world, {0.9, 0}, 11);
  EXPECT_GT(world.robot().x, 15.5);
}

TEST(World, RefusesUnknownNamesWithTheNearestOne) {
  World world(LoadInstitute());
  EXPECT_THAT(world.SetPlaceBlocked("coridor_east", true).problem(),
              HasSubstr("did you mean \"corridor_east\"?"));
  EXPECT_THAT(world.SetDoorOpen("x", true).problem(), HasSubstr("door_101, door_102"));
}

TEST(World, BlockingTheCorridorLeavesNoGapForTheRobot) {
  const Floor floor = LoadInstitute();
  for (const FloorBox& place : floor.places) {
    if (place.name.rfind("corridor_", 0) != 0) continue;
    const double gap = 1.25 - place.shape.size.y / 2;
    EXPECT_LT(gap, 2 * kRobotRadius) << place.name;
  }
}

TEST(World, PeopleNeverPushTheRobot) {
  Floor floor = MakeRoom();
  floor.people = {{"anna", 1.2, {{2, 0}, {18, 0}}}};
  World world(floor, At(10, 0, 0));
  for (int i = 0; i < 3000; ++i) {
    world.Step(kDt);
    ASSERT_NEAR(world.robot().x, 10, 1e-6);
    ASSERT_GE(Length(world.people()[0].center - world.robot().position()),
              kRobotRadius + kPersonRadius + kPersonDistance - 1e-6);
  }
}

TEST(World, TheLaserLooksBetweenTheLegsOfWhoStandsBeforeIt) {
  Floor floor = MakeRoom();
  floor.people = {{"anna", 1.2, {{12, 0}, {18, 0}}}};
  const World world(floor, At(10, 0, 0));
  const std::vector<float>& ranges = world.scan().ranges;
  EXPECT_NEAR(ranges[270], 9.75, 0.05);  // the wall behind
  EXPECT_NEAR(ranges[273], 1.7, 0.1);    // 1.5 degrees aside
  EXPECT_NEAR(ranges[267], 1.7, 0.1);
}

TEST(World, OdometryDoesNotNoticeAKidnapping) {
  World world(MakeRoom(), At(5, 0, 0));
  Drive(world, {0.5, 0}, 2);
  const Pose2 before = world.odometry().pose();
  EXPECT_TRUE(world.Kidnap({12, 1, 1.5}));
  world.Step(kDt, Velocity{});
  EXPECT_NEAR(world.robot().x, 12, 0.01);
  EXPECT_NEAR(world.robot().yaw, 1.5, 0.01);
  EXPECT_NEAR(world.odometry().pose().x, before.x, 0.05);
  EXPECT_NEAR(world.odometry().pose().yaw, before.yaw, 0.01);
  EXPECT_NEAR(world.imu().yaw_rate, 0, 0.05);
}

TEST(World, NobodyIsKidnappedIntoAWallACupboardOrOutOfTheHouse) {
  World world(LoadInstitute());
  for (const Pose2& pose : {Pose2{10, 1.2, 0}, Pose2{11, 6, 0}, Pose2{60, 0, 0},
                            Pose2{std::nan(""), 0, 0}, Pose2{-2.94, 0, 0}}) {
    EXPECT_FALSE(world.Kidnap(pose)) << pose.x;
  }
  EXPECT_TRUE(world.docked());
}

TEST(World, TheSameSeedGivesTheSameTrace) {
  const auto trace = [](std::uint64_t seed) {
    WorldOptions options = At(4, 0, 0);
    options.seed = seed;
    World world(LoadInstitute(), options);
    std::vector<double> values;
    for (int i = 0; i < 1500; ++i) {
      world.Step(kDt, Velocity{0.6, 0.4 * std::sin(0.01 * i)});
      values.insert(values.end(), {world.robot().x, world.robot().y, world.odometry().pose().x,
                                   world.imu().yaw_rate, world.scan().ranges[100]});
    }
    return values;
  };
  EXPECT_EQ(trace(3), trace(3));
  EXPECT_NE(trace(3), trace(4));
}

}  // namespace
}  // namespace coppice::robot::simulation
