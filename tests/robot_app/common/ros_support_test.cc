#include "robot_app/common/ros_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot {
namespace {

using testing::HasSubstr;

geometry_msgs::TransformStamped Transform(const std::string& parent, const std::string& child,
                                          const Pose2D& pose, const ros::Time& stamp) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  const geometry_msgs::Pose place = ToPoseMessage(pose);
  message.transform.translation.x = place.position.x;
  message.transform.translation.y = place.position.y;
  message.transform.rotation = place.orientation;
  return message;
}

TEST(RosMessages, PosesSurviveTheWayThere) {
  const Pose2D pose = ToPose2D(ToPoseMessage({1, -2, 2.5}));
  EXPECT_DOUBLE_EQ(pose.x, 1);
  EXPECT_DOUBLE_EQ(pose.y, -2);
  EXPECT_NEAR(pose.yaw, 2.5, 1e-12);
}

TEST(RosMessages, APoseWithoutARotationIsNotValid) {
  geometry_msgs::Pose pose;
  EXPECT_FALSE(IsValid(pose));
  pose.orientation.w = 1;
  EXPECT_TRUE(IsValid(pose));
  pose.position.x = NAN;
  EXPECT_FALSE(IsValid(pose));
}

TEST(RosMessages, AGridMustHaveItsCellsAndNoRotation) {
  nav_msgs::OccupancyGrid message;
  message.info.resolution = 0.05F;
  message.info.width = 3;
  message.info.height = 2;
  message.info.origin.orientation.w = 1;
  message.info.origin.position.x = -3;
  message.data.assign(6, 100);
  const Expected<OccupancyGrid> grid = ToGrid(message);
  ASSERT_TRUE(grid) << grid.problem();
  EXPECT_DOUBLE_EQ(grid->frame.origin_x, -3);
  EXPECT_EQ(grid->frame.size(), 6);
  message.info.origin.orientation = ToPoseMessage({0, 0, 0.1}).orientation;
  EXPECT_THAT(ToGrid(message).problem(), HasSubstr("rotated"));
  message.info.origin.orientation = ToPoseMessage({0, 0, 0}).orientation;
  message.data.pop_back();
  EXPECT_THAT(ToGrid(message).problem(), HasSubstr("cells"));
}

TEST(RosMessages, AGridMustHaveASizeAndAPlaceThatAMapCanHave) {
  nav_msgs::OccupancyGrid good;
  good.info.resolution = 0.05F;
  good.info.width = good.info.height = 1;
  good.info.origin.orientation.w = 1;
  good.data.assign(1, 0);
  ASSERT_TRUE(ToGrid(good));
  for (const float resolution : {1e-9F, 0.0F, -1.0F, 1e30F, NAN}) {
    nav_msgs::OccupancyGrid message = good;
    message.info.resolution = resolution;
    EXPECT_THAT(ToGrid(message).problem(), HasSubstr("1 mm to 10 m")) << resolution;
  }
  nav_msgs::OccupancyGrid message = good;
  message.info.origin.position.x = NAN;
  EXPECT_THAT(ToGrid(message).problem(), HasSubstr("no place"));
  message = good;
  message.info.origin.orientation.w = NAN;
  EXPECT_THAT(ToGrid(message).problem(), HasSubstr("rotated"));
}

nav_msgs::OccupancyGrid Map(float resolution, std::uint32_t width, std::uint32_t height) {
  nav_msgs::OccupancyGrid message;
  message.info.resolution = resolution;
  message.info.width = width;
  message.info.height = height;
  message.info.origin.orientation.w = 1;
  message.data.assign(std::size_t{width} * height, 0);
  return message;
}

TEST(RosMessages, AGridForWhichThereIsNoRoomIsRefused) {
  EXPECT_TRUE(ToGrid(Map(0.05F, 2000, 2500)));
  EXPECT_THAT(ToGrid(Map(0.05F, 5000, 5000)).problem(), HasSubstr("5000 x 5000 cells of 0.05 m"));
  EXPECT_THAT(ToGrid(Map(5, 400, 400)).problem(), HasSubstr("at most 5000000 cells"));
  EXPECT_THAT(ToGrid(Map(1, 1, 1001)).problem(), HasSubstr("1000 m"));
}

TEST(RosMessages, OfAGridOfWhichLittleIsKnownThatIsTaken) {
  nav_msgs::OccupancyGrid message = Map(0.05F, 4000, 4000);  // as slam_gmapping draws it
  message.info.origin.position.x = message.info.origin.position.y = -100;
  std::fill(message.data.begin(), message.data.end(), -1);
  message.data[2000 * 4000 + 2010] = 100;
  message.data[2003 * 4000 + 2001] = 0;
  const Expected<OccupancyGrid> grid = ToGrid(message);
  ASSERT_TRUE(grid) << grid.problem();
  EXPECT_EQ(grid->frame.width, 10);
  EXPECT_EQ(grid->frame.height, 4);
  EXPECT_NEAR(grid->frame.origin_x, 0.05, 1e-5);
  EXPECT_NEAR(grid->frame.origin_y, 0, 1e-5);
  EXPECT_EQ(grid->cells[9], 100);
  EXPECT_EQ(grid->cells[30], 0);
  std::fill(message.data.begin(), message.data.end(), -1);
  EXPECT_THAT(ToGrid(message).problem(), HasSubstr("4000 x 4000")) << "nothing is known";
}

TEST(RosMessages, AScannerThatSeesWithoutEndSeesAsFarAsOthers) {
  sensor_msgs::LaserScan message;
  message.range_max = std::numeric_limits<float>::infinity();
  message.ranges = {1e30F, 2};
  const LaserScan scan = ToLaserScan(message, {});
  EXPECT_EQ(scan.range_max, kFarthestRange);
  EXPECT_TRUE(scan.MetNothing(0));
  EXPECT_TRUE(scan.Hit(1));
  message.range_max = NAN;
  EXPECT_FALSE(IsUsable(ToLaserScan(message, {})));
}

TEST(RosMessages, ScansKeepTheirTimeAndBeams) {
  sensor_msgs::LaserScan message;
  message.header.stamp = ros::Time(12.5);
  message.angle_min = -1;
  message.angle_increment = 0.5;
  message.range_max = 20;
  message.ranges = {1, 2};
  const LaserScan scan = ToLaserScan(message, {0.25, 0, 0});
  EXPECT_DOUBLE_EQ(scan.stamp, 12.5);
  EXPECT_DOUBLE_EQ(scan.mount.x, 0.25);
  EXPECT_EQ(scan.ranges.size(), 2u);
  EXPECT_DOUBLE_EQ(scan.range_max, 20);
}

TEST(RosSupport, ARangeKeepsItsConeAndItsLimits) {
  sensor_msgs::Range message;
  message.header.stamp = ros::Time(12.5);
  message.field_of_view = 0.5F;
  message.min_range = 0.25F;
  message.max_range = 4;
  message.range = 1.5F;
  const RangeReading reading = ToRangeReading(message, {0.33, 0, 0});
  EXPECT_DOUBLE_EQ(reading.stamp, 12.5);
  EXPECT_DOUBLE_EQ(reading.mount.x, 0.33);
  EXPECT_DOUBLE_EQ(reading.field_of_view, 0.5);
  EXPECT_DOUBLE_EQ(reading.min_range, 0.25);
  EXPECT_DOUBLE_EQ(reading.max_range, 4);
  EXPECT_DOUBLE_EQ(reading.range, 1.5);
}

TEST(RobotPose, IsLocalizationTimesOdometryAndAsOldAsTheOlder) {
  RobotPose robot({"map", "odom", "base_link"});
  EXPECT_FALSE(robot.Newest());
  tf2_ros::TransformBroadcaster broadcaster;
  tf2_ros::StaticTransformBroadcaster fixed;
  fixed.sendTransform(Transform("base_link", "laser", {0.25, 0, 0}, ros::Time(1)));
  ASSERT_TRUE(Eventually([&] {
    broadcaster.sendTransform(Transform("map", "odom", {1, 0, M_PI / 2}, ros::Time(10)));
    broadcaster.sendTransform(Transform("odom", "base_link", {2, 0, 0}, ros::Time(10.5)));
    broadcaster.sendTransform(Transform("odom", "base_link", {3, 0, 0}, ros::Time(11)));
    return robot.Newest() && robot.MountOf("laser") && robot.At(ros::Time(10.5))->x != 0 &&
           std::abs(robot.Newest()->pose.y - 3) < 1e-9;
  }));
  EXPECT_NEAR(robot.Newest()->pose.x, 1, 1e-9);
  EXPECT_DOUBLE_EQ(robot.Newest()->stamp, 10);
  EXPECT_NEAR(robot.At(ros::Time(10.5))->y, 2, 1e-9);
  EXPECT_NEAR(robot.At(ros::Time(99))->y, 3, 1e-9) << "the newest when tf has not that time";
  EXPECT_NEAR(robot.MountOf("laser")->x, 0.25, 1e-9);
  EXPECT_FALSE(robot.MountOf("camera"));
  geometry_msgs::PoseStamped goal;
  goal.header.frame_id = "odom";
  goal.pose = ToPoseMessage({1, 0, 0});
  ASSERT_TRUE(robot.InMap(goal));
  EXPECT_NEAR(robot.InMap(goal)->y, 1, 1e-9);
  goal.header.frame_id = "moon";
  EXPECT_FALSE(robot.InMap(goal));
}

TEST(RobotPose, AScanIsBelievedToBeOfNowThoughTheClockOfTheScannerIsAhead) {
  const RobotPose robot({"map", "odom", "base_link"});
  tf2_ros::StaticTransformBroadcaster fixed;
  fixed.sendTransform(Transform("base_link", "laser", {0.25, 0, 0}, ros::Time(1)));
  ASSERT_TRUE(Eventually([&] { return robot.MountOf("laser").has_value(); }));
  sensor_msgs::LaserScan message;
  message.header.frame_id = "laser";
  message.header.stamp = ros::Time::now() + ros::Duration(8);
  message.angle_increment = 0.01F;
  message.range_max = 25;
  message.ranges.assign(100, 2);
  const auto scan = robot.UsableScan(message);
  ASSERT_TRUE(scan);
  EXPECT_LT(scan->stamp, ros::Time::now().toSec() + 1);
}

}  // namespace
}  // namespace coppice::robot
