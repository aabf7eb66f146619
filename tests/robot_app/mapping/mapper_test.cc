#include "robot_app/mapping/mapper.h"

#include <gtest/gtest.h>

#include <memory>

#include "tests/robot_app/localization/localized_robot.h"
#include "tests/robot_app/mapping/map_quality.h"
#include "tests/robot_app/mapping/mapped_robot.h"

namespace coppice::robot::mapping {
namespace {

using navigation::InstituteFloor;
using simulation::Floor;

constexpr Pose2D kBeforeTheStation{-0.5, 0, 0};

// One round through the institute with its people.
class MapOfTheInstitute : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    robot_ = std::make_unique<MappedRobot>(InstituteFloor(), kBeforeTheStation, 1);
    ASSERT_TRUE(robot_->Drive(RoundOfTheInstitute()));
    map_ = robot_->mapper().Map();
    RecordProperty("farthest_off_mm", static_cast<int>(1000 * robot_->farthest_off()));
  }
  static void TearDownTestSuite() { robot_.reset(); }

  static std::unique_ptr<MappedRobot> robot_;
  static OccupancyGrid map_;
};

std::unique_ptr<MappedRobot> MapOfTheInstitute::robot_;
OccupancyGrid MapOfTheInstitute::map_;

TEST_F(MapOfTheInstitute, DriftsByCentimetresInOneRound) {
  EXPECT_LT(robot_->farthest_off(), 0.15);
  EXPECT_LT(robot_->Error(), 0.1);
  const MappingReport report = robot_->mapper().Report();
  EXPECT_GT(report.way, 130);
  EXPECT_GT(report.key_frames, 200u);
  EXPECT_GT(report.loops, 5u);  // it has come back the same way
  EXPECT_TRUE(report.fits) << report.score;
}

TEST_F(MapOfTheInstitute, ShowsTheWallsAndNothingElse) {
  const OccupancyGrid floor = navigation::MapOf(InstituteFloor());
  EXPECT_GT(ShareNear(map_, floor, 0.1), 0.8);
  EXPECT_GT(ShareNear(map_, floor, 0.15), 0.99);  // nobody who walked by is left
  EXPECT_GT(ShareNear(floor, map_, 0.1, {-2.9, -1.4}, {40, 1.4}), 0.95);  // corridor
  EXPECT_GT(ShareNear(floor, map_, 0.1, {40.5, -6.1}, {49, 6.1}), 0.7);   // hall; some is hidden
}

TEST_F(MapOfTheInstitute, IsFreeWhereTheRobotWas) {
  for (const Point2D& point : RoundOfTheInstitute()) {
    const Cell cell = map_.frame.CellAt(point.x, point.y);
    ASSERT_TRUE(map_.frame.Contains(cell));
    EXPECT_FALSE(map_.Blocked(map_.frame.Index(cell))) << point.x << " " << point.y;
  }
}

TEST_F(MapOfTheInstitute, WillDoForLocalization) {
  localization::LocalizedRobot robot(InstituteFloor(), kBeforeTheStation, 7);
  robot.localizer().SetMap(map_);
  robot.localizer().Expect({kBeforeTheStation});
  Tour tour({{30, 0}, {45, 0}, {46, 4}, {46, -3}, {42.5, 0}});
  int steps = 0;
  int ok = 0;
  double worst = 0;
  while (const auto command = tour.Next(robot.Truth())) {
    ASSERT_LT(++steps, 20000);
    robot.Step(*command);
    if (!robot.IsOk()) continue;
    ++ok;
    worst = std::max(worst, robot.Error());
  }
  EXPECT_GT(ok, 0.98 * steps);
  EXPECT_LT(worst, 0.15);
}

// A corridor of 3 m round a block of 12 m, with a few things that make its sides differ.
Floor RingFloor() {
  Floor floor;
  floor.name = "ring";
  floor.walls = {{{0, 0}, {18, 0}, {18, 18}, {0, 18}, {0, 0}},
                 {{3, 3}, {15, 3}, {15, 15}, {3, 15}, {3, 3}}};
  const auto add = [&floor](simulation::Vec2 at, simulation::Vec2 size) {
    floor.furniture.push_back({"thing", {at, size, 0.2}, 1});
  };
  add({6, 0.4}, {0.8, 0.6});
  add({17.6, 5}, {0.5, 1.5});
  add({17.5, 11}, {0.4, 0.4});
  add({13, 17.5}, {1.2, 0.7});
  add({7, 15.4}, {0.5, 0.5});
  add({0.4, 13}, {0.5, 0.9});
  add({2.6, 8}, {0.6, 0.6});
  floor.docked = {1.5, 1.5, 0};
  floor.staging = {1.5, 1.5, 0};
  return floor;
}

TEST(Mapper, ClosesARingThatBadOdometryHasTornOpen) {
  const Floor floor = RingFloor();
  MappedRobot robot(floor, {1.5, 1.5, 0}, 3, {0.04, 0.01});
  const std::vector<Point2D> once = {{16.5, 1.5}, {16.5, 16.5}, {1.5, 16.5}, {1.5, 1.5}};
  ASSERT_TRUE(robot.Drive(once));
  ASSERT_TRUE(robot.Drive({{12, 1.5}}));
  const double odometry_off =
      Distance(Compose(Pose2D{1.5, 1.5, 0}, robot.believed()), robot.Truth());
  EXPECT_GT(odometry_off, 3);
  EXPECT_GE(robot.mapper().Report().loops, 1u);
  EXPECT_LT(robot.Error(), 0.3);
  // The walls where it began are there once.
  const OccupancyGrid truth = navigation::MapOf(floor);
  EXPECT_GT(ShareNear(robot.mapper().Map(), truth, 0.3), 0.95);
  EXPECT_GT(ShareNear(robot.mapper().Map(), truth, 0.2, {-1, -1}, {12, 4}), 0.97);
}

TEST(Mapper, GoesOnWhenTheOdometryBeginsAnew) {
  Floor floor = InstituteFloor();
  floor.people.clear();
  MappedRobot robot(floor, kBeforeTheStation, 4);
  ASSERT_TRUE(robot.Drive({{6, 0}}));
  robot.RestartOdometry();
  ASSERT_TRUE(robot.Drive({{12, 0}}));
  EXPECT_LT(robot.Error(), 0.1);
  EXPECT_GT(ShareNear(robot.mapper().Map(), navigation::MapOf(floor), 0.1), 0.97);
}

TEST(Mapper, KeepsNothingWhileTheRobotStands) {
  Floor floor = InstituteFloor();
  MappedRobot robot(floor, kBeforeTheStation, 5);
  EXPECT_FALSE(robot.mapper().started());
  for (int i = 0; i < 500; ++i) robot.Step({});
  EXPECT_EQ(robot.mapper().Report().key_frames, 1u);
  EXPECT_EQ(robot.mapper().revision(), 1u);
  EXPECT_NEAR(robot.mapper().pose().x, kBeforeTheStation.x, 0.01);
}

TEST(Mapper, SaysWhatItWaitsFor) {
  Mapper mapper;
  mapper.AddScan({});
  mapper.AddOdometry(NAN, {});
  EXPECT_FALSE(mapper.started());
  EXPECT_NE(mapper.Report().message.find("waits"), std::string::npos);
}

TEST(Mapper, SaysThatWhatItSeesDoesNotFit) {
  Floor floor = InstituteFloor();
  floor.people.clear();
  MappedRobot robot(floor, {46, 0, 0}, 6);
  ASSERT_TRUE(robot.Drive({{47, 0}}));
  EXPECT_TRUE(robot.mapper().Report().fits);
  robot.Carry({6, 3.5, 1});
  ASSERT_TRUE(robot.Drive({{7, 4.2}}));
  EXPECT_FALSE(robot.mapper().Report().fits) << robot.mapper().Report().score;
}

TEST(Mapper, SaysThatItCanTakeInNoMore) {
  MappingSettings settings;
  settings.most_frames = 5;
  Floor floor = InstituteFloor();
  floor.people.clear();
  MappedRobot robot(floor, kBeforeTheStation, 8, {}, settings);
  ASSERT_TRUE(robot.Drive({{4, 0}}));
  const MappingReport report = robot.mapper().Report();
  EXPECT_EQ(report.key_frames, 5u);
  EXPECT_NE(report.message.find("save it"), std::string::npos) << report.message;
  EXPECT_LT(robot.Error(), 0.1);  // it goes on by odometry
}

TEST(Mapper, SurvivesScansWithoutSense) {
  Mapper mapper;
  for (int i = 0; i < 50; ++i) {
    mapper.AddOdometry(i, {0.5 * i, 0, 0});
    LaserScan scan;
    scan.stamp = i;
    if (i % 3 == 1) scan.ranges.assign(541, NAN);
    if (i % 3 == 2) scan.ranges.assign(541, INFINITY);
    mapper.AddScan(scan);
  }
  EXPECT_EQ(mapper.Report().key_frames, 50u);
  EXPECT_NEAR(mapper.pose().x, 24.5, 1e-6);
}

}  // namespace
}  // namespace coppice::robot::mapping
