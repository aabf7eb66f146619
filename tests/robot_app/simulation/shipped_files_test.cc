#include "robot_app/simulation/shipped_files.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace coppice::robot::simulation {
namespace {

// The shipped robot with a text replaced by another.
RobotDescription Changed(const std::string& from, const std::string& to) {
  std::string text = FindRobot(kSobi)->text();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  const TemporaryFolder folder;
  std::ofstream(folder.Path("robot.urdf")) << text.replace(at, from.size(), to);
  return FindRobot(folder.Path("robot.urdf")).value();
}

// Who makes a World without a description, as trainings and tests do, simulates the same robot.
TEST(ShippedFiles, TheDefaultsAreThoseOfTheShippedRobot) {
  const WorldOptions defaults;
  WorldOptions shipped;
  const Outcome applied = Apply(FindRobot(kSobi).value(), shipped);
  ASSERT_TRUE(applied) << applied.problem();
  EXPECT_DOUBLE_EQ(shipped.radius, defaults.radius);
  EXPECT_DOUBLE_EQ(shipped.lidar.mounting.x, defaults.lidar.mounting.x);
  EXPECT_DOUBLE_EQ(shipped.lidar.height, defaults.lidar.height);
  EXPECT_DOUBLE_EQ(shipped.lidar_3d.mounting.x, defaults.lidar_3d.mounting.x);
  EXPECT_DOUBLE_EQ(shipped.lidar_3d.height, defaults.lidar_3d.height);
  for (std::size_t i = 0; i < kSonars.size(); ++i) {
    EXPECT_DOUBLE_EQ(shipped.sonars[i].mounting.x, defaults.sonars[i].mounting.x) << kSonars[i];
    EXPECT_DOUBLE_EQ(shipped.sonars[i].mounting.y, defaults.sonars[i].mounting.y) << kSonars[i];
    EXPECT_NEAR(shipped.sonars[i].mounting.yaw, defaults.sonars[i].mounting.yaw, 1e-6);
    EXPECT_DOUBLE_EQ(shipped.sonars[i].height, defaults.sonars[i].height) << kSonars[i];
  }
  EXPECT_DOUBLE_EQ(shipped.odometry.track, defaults.odometry.track);
  EXPECT_DOUBLE_EQ(shipped.odometry.wheel_diameter, defaults.odometry.wheel_diameter);
}

TEST(ShippedFiles, ALaserThatIsMountedElsewhereMeasuresFromThere) {
  WorldOptions options;
  ASSERT_TRUE(Apply(Changed("xyz=\"0.25 0 0.3\"", "xyz=\"0.1 0.2 0.4\" rpy=\"0 0 1\""), options));
  EXPECT_DOUBLE_EQ(options.lidar.mounting.x, 0.1);
  EXPECT_DOUBLE_EQ(options.lidar.mounting.y, 0.2);
  EXPECT_NEAR(options.lidar.mounting.yaw, 1, 1e-9);
  EXPECT_DOUBLE_EQ(options.lidar.height, 0.4);
}

TEST(ShippedFiles, AWiderRobotIsWider) {
  WorldOptions options;
  ASSERT_TRUE(
      Apply(Changed("radius=\"0.33\" length=\"1.56\"", "radius=\"0.4\" length=\"1.56\""), options));
  EXPECT_DOUBLE_EQ(options.radius, 0.4);
}

TEST(ShippedFiles, ALidarThatDoesNotStandLevelIsAProblem) {
  WorldOptions options;
  const Outcome applied =
      Apply(Changed("xyz=\"0 0 1.2\"", "xyz=\"0 0 1.2\" rpy=\"0 0.2 0\""), options);
  EXPECT_THAT(applied.problem(), testing::HasSubstr("\"velodyne\" does not stand level"));
}

TEST(ShippedFiles, AFloorIsShippedOrAFileOrAProblemThatNamesIt) {
  EXPECT_EQ(FindFloor(kInstitute)->name, "institute");
  EXPECT_THAT(FindFloor("/no/floor.yaml").problem(), testing::HasSubstr("/no/floor.yaml"));
}

}  // namespace
}  // namespace coppice::robot::simulation
