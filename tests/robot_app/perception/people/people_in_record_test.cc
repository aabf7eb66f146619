#include "robot_app/perception/people/people_in_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <tf2_msgs/TFMessage.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include "robot_app/perception/people/record_command.h"
#include "robot_app/simulation/cloud_message.h"
#include "robot_app/simulation/lidar.h"
#include "robot_app/simulation/lidar_3d.h"
#include "robot_app/simulation/sensor_messages.h"
#include "tests/support/folders.h"

namespace coppice::robot::perception {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr double kBegin = 100;  // s
constexpr double kStep = 0.02;
const std::string kClassifier = SourceFolder() + "/robot_app/perception/data/people_in_clouds.yaml";

const std::string kLegs = SourceFolder() + "/robot_app/perception/data/legs_in_scans.yaml";

Classifiers Shipped() {
  auto classifiers = Classifiers::Load(kClassifier, kLegs);
  EXPECT_TRUE(classifiers) << classifiers.problem();
  return std::move(*classifiers);
}

// Where a sensor is, for ever.
tf2_msgs::TFMessage Mount(const char* sensor, double height) {
  geometry_msgs::TransformStamped mount;
  mount.header.frame_id = "odom";
  mount.child_frame_id = sensor;
  mount.transform.translation.z = height;
  mount.transform.rotation.w = 1;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(mount);
  return message;
}

simulation::StillScene Hall() {
  simulation::StillScene still;
  still.ceiling = 3;
  still.AddBox({{0, 0}, {12, 12}, 0}, 3, simulation::Material::kWall);
  return still;
}

simulation::Figure PasserBy(double time) {
  simulation::Stance stance;
  stance.position = {2, -2.5 + time};
  stance.heading = simulation::kPi / 2;
  stance.walks = true;
  stance.walked = time;
  return simulation::MakeFigure(stance);
}

// The same as the laser sees it, without the lidar.
std::string WriteRecordOfLaser(const std::string& name) {
  const fs::path path = fs::path(BinaryFolder()) / "tests" / name;
  fs::remove(path);
  rosbag::Bag bag(path.string(), rosbag::bagmode::Write);
  bag.write("/tf_static", ros::Time(kBegin), Mount("laser", 0.3));
  simulation::LidarOptions options;
  options.mounting = {0, 0, 0};
  simulation::Lidar laser(options, 1);
  const simulation::RayCaster walls(simulation::EdgesFrom(options.height, Hall()));
  for (double time = 0; time < 5; time += options.period) {
    laser.Measure(time, {0, 0, 0}, walls, simulation::SlicesAt(options.height, {PasserBy(time)}));
    sensor_msgs::LaserScan scan = simulation::ToMessage(laser.scan(), options);
    scan.header.stamp = ros::Time(kBegin + time);
    bag.write("/scan", ros::Time(kBegin + time), scan);
  }
  return path.string();
}

// A robot that stands in a hall, and somebody who walks past it for five seconds.
std::string WriteRecord(const std::string& name) {
  const fs::path path = fs::path(BinaryFolder()) / "tests" / name;
  fs::remove(path);
  rosbag::Bag bag(path.string(), rosbag::bagmode::Write);
  bag.write("/tf_static", ros::Time(kBegin), Mount("velodyne", 1.2));
  const simulation::StillScene hall = Hall();
  simulation::Scene scene(hall);
  simulation::Lidar3d lidar({}, 1);
  double written = -1;
  for (double time = 0; time < 5; time += kStep) {
    scene.SetFigures({PasserBy(time)});
    lidar.Turn(time, kStep, {0, 0, 0}, scene);
    if (lidar.cloud().points.empty() || lidar.cloud().time == written) continue;
    written = lidar.cloud().time;
    sensor_msgs::PointCloud2 cloud = simulation::ToMessage(lidar.cloud(), lidar.options().rings);
    cloud.header.frame_id = "velodyne";
    cloud.header.stamp = ros::Time(kBegin + written);
    bag.write("/velodyne_points", ros::Time(kBegin + time), cloud);
  }
  return path.string();
}

TEST(PeopleInRecord, WhoWalkedByIsOnePersonWithAWay) {
  const auto figures = FollowInRecord(WriteRecord("walks_by.bag"), {}, Shipped());
  ASSERT_TRUE(figures) << figures.problem();
  EXPECT_GT(figures->clouds, 40);
  EXPECT_EQ(figures->refused, 0) << figures->problem;
  ASSERT_EQ(figures->people.size(), 1u) << Table(*figures);
  const PersonInRecord& person = figures->people.begin()->second;
  EXPECT_GT(person.last_seen - person.first_seen, 4);
  EXPECT_NEAR(person.trail.back().y() - person.trail.front().y(), 4.5, 0.8);
}

TEST(PeopleInRecord, WithoutCloudsWhoWalkedByIsKnownByTheLegs) {
  const auto figures = FollowInRecord(WriteRecordOfLaser("legs.bag"), {}, Shipped());
  ASSERT_TRUE(figures) << figures.problem();
  EXPECT_EQ(figures->clouds, 0);
  EXPECT_GT(figures->scans, 40);
  EXPECT_EQ(figures->refused, 0) << figures->problem;
  ASSERT_EQ(figures->people.size(), 1u) << Table(*figures);
  const PersonInRecord& person = figures->people.begin()->second;
  EXPECT_NEAR(person.trail.back().y() - person.trail.front().y(), 4, 0.8);
}

TEST(PeopleInRecord, PicturesAreDrawnOneASecond) {
  const fs::path folder = fs::path(BinaryFolder()) / "tests" / "walks_by";
  fs::remove_all(folder);
  const std::string record = WriteRecord("drawn.bag");
  EXPECT_EQ(
      LookIntoRecord({"--offline", record, "--pictures", folder.string()}, kClassifier, kLegs), 0);
  EXPECT_TRUE(fs::exists(folder / "00004.jpg"));
  EXPECT_FALSE(fs::exists(folder / "00006.jpg"));
}

TEST(PeopleInRecord, HelpIsNoFile) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(LookIntoRecord({"--offline", "--help"}, kClassifier, kLegs), 0);
  EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("--pictures"));
}

TEST(PeopleInRecord, WhatIsNoRecordIsAProblemThatNamesIt) {
  const std::string path = BinaryFolder() + "/tests/no.bag";
  std::ofstream(path) << "#ROSBAG V2.0\nand then nothing";
  const auto figures = FollowInRecord(path, {}, Shipped());
  ASSERT_FALSE(figures);
  EXPECT_THAT(figures.problem(), HasSubstr("no.bag"));
  EXPECT_FALSE(FollowInRecord("/nowhere.bag", {}, Shipped()));
}

TEST(PeopleInRecord, ScansThatNobodyCanUseAreCounted) {
  const std::string path = BinaryFolder() + "/tests/broken_scans.bag";
  {
    rosbag::Bag bag(path, rosbag::bagmode::Write);
    sensor_msgs::LaserScan scan;  // without beams
    for (const double time : {0.0, 1.0, 2.0}) {
      scan.header.stamp = ros::Time(kBegin + time);
      if (time > 1) scan.ranges.resize(100000, 1.0F);
      bag.write("/scan", scan.header.stamp, scan);
    }
  }
  const auto figures = FollowInRecord(path, {}, Shipped());
  ASSERT_TRUE(figures) << figures.problem();
  EXPECT_EQ(figures->scans, 0);
  EXPECT_EQ(figures->refused, 2);  // of the first it is not yet clear whether clouds come
}

TEST(PeopleInRecord, MessagesThatNobodyCanUseAreCounted) {
  const std::string path = BinaryFolder() + "/tests/broken.bag";
  {
    rosbag::Bag bag(path, rosbag::bagmode::Write);
    sensor_msgs::PointCloud2 cloud;
    cloud.header.stamp = ros::Time(kBegin);
    cloud.width = 1000;
    cloud.height = 1000;
    cloud.point_step = 22;
    bag.write("/velodyne_points", ros::Time(kBegin), cloud);
  }
  const auto figures = FollowInRecord(path, {}, Shipped());
  ASSERT_TRUE(figures) << figures.problem();
  EXPECT_EQ(figures->refused, 1);
  EXPECT_THAT(Table(*figures), HasSubstr("1000 x 1000"));
}

}  // namespace
}  // namespace coppice::robot::perception
