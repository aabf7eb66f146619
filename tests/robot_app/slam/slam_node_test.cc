// The program coppice-slam with the simulator and its cameras over ROS, and coppice-map on its map.
#include <coppice_msgs/InjectFault.h>
#include <coppice_msgs/LocalizationState.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/Twist.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <std_srvs/Trigger.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "robot_app/common/child_process.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/slam/map/slam_map_file.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/latest.h"
#include "tests/robot_app/processes/temporary.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/robot_app/text_of.h"
#include "tests/support/folders.h"

namespace coppice::robot::slam {
namespace {

using processes::Temporary;
using testing::HasSubstr;

constexpr double kPatience = 60;  // wall time, for whatever is waited for [s]
const std::string kPrograms = BinaryFolder() + "/bin/";

class SlamNodeTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(kMaps);
    command_ = node_.advertise<geometry_msgs::Twist>("/cmd_vel", 1);
  }

  void StartSimulator(const std::string& start = "2 0 0",
                      const std::string& localization = "true") {
    ros::param::set("/use_sim_time", true);  // before anybody starts
    simulator_ = ChildProcess({kPrograms + "coppice-simulator", "_start:=" + start,
                               "/odom:=/odometry/filtered", "_localization:=" + localization},
                              Temporary("simulator.log"));
    cameras_ = ChildProcess({kPrograms + "coppice-simulated-cameras"}, Temporary("cameras.log"));
  }
  void StartSlam(const std::string& session) {
    slam_ = ChildProcess({kPrograms + "coppice-slam", "_map_folder:=" + kMaps,
                          "_session:=" + session, "_grid_period:=1"},
                         Temporary("slam.log"));
  }
  // Somebody carries it there as soon as nobody stands there.
  void Carry(const std::string& where) {
    coppice_msgs::InjectFault service;
    service.request.fault = "kidnap";
    service.request.target = where;
    EXPECT_TRUE(Eventually(
        [&] {
          return ros::service::call("/simulation/inject_fault", service) && service.response.ok;
        },
        kPatience))
        << service.response.message;
  }
  bool DriveUntil(const std::function<bool()>& done) {
    return Eventually(
        [&] {
          geometry_msgs::Twist twist;
          twist.linear.x = 0.4;
          command_.publish(twist);
          return done();
        },
        kPatience);
  }
  static int RunToTheEnd(const std::vector<std::string>& command, const std::string& log) {
    ChildProcess process(command, log);
    EXPECT_TRUE(Eventually([&] { return !process.IsRunning(); }, kPatience));
    return process.exit_status();
  }

  const std::string kMaps = Temporary("maps");
  ros::NodeHandle node_;
  ros::Publisher command_;
  ChildProcess simulator_, cameras_, slam_, localization_;
};

TEST_F(SlamNodeTest, MapsFollowsSavesAndGoesOnInANewSession) {
  StartSimulator();
  StartSlam("monday");
  const Latest<geometry_msgs::PoseStamped> pose(node_, "/slam/pose");
  const Latest<geometry_msgs::PoseStamped> truth(node_, "/simulation/truth");
  const Latest<nav_msgs::OccupancyGrid> grid(node_, "/slam/grid");
  // The frame of a new map begins where the robot stood at the first key frame: at (2, 0).
  ASSERT_TRUE(Eventually([&] { return pose.get() != nullptr; }, kPatience));
  ASSERT_TRUE(DriveUntil([&] { return truth.get() && truth.get()->pose.position.x > 4; }));
  // On a busy computer it is behind while the robot drives; then it stands.
  ASSERT_TRUE(Eventually(
      [&] {
        return std::abs(pose.get()->pose.position.x + 2 - truth.get()->pose.position.x) < 0.2;
      },
      kPatience));
  EXPECT_EQ(pose.get()->header.frame_id, "slam_map");
  ASSERT_TRUE(Eventually(
      [&] {
        const auto map = grid.get() ? ToGrid(*grid.get()) : Expected<OccupancyGrid>(Problem{""});
        if (!map) return false;
        const Cell wall = map->frame.CellAt(1, 1.27);
        return map->frame.Contains(wall) &&
               map->cells[static_cast<std::size_t>(map->frame.Index(wall))] == 100;
      },
      kPatience));
  const Latest<visualization_msgs::MarkerArray> graph(node_, "/slam/graph");
  ASSERT_TRUE(Eventually([&] { return graph.get() != nullptr; }, kPatience));
  EXPECT_GE(graph.get()->markers[0].points.size(), 4U);
  const Latest<diagnostic_msgs::DiagnosticArray> state(node_, "/diagnostics");
  const auto says = [&](const std::string& message) {
    const auto newest = state.get();
    if (!newest) return false;
    const auto& all = newest->status;
    return std::any_of(all.begin(), all.end(), [&message](const auto& status) {
      return status.name == "slam: map" && status.message == message;
    });
  };
  EXPECT_TRUE(Eventually([&] { return says("maps: indoor"); }, kPatience));
  ros::param::set("/slam/surroundings", "hall");
  EXPECT_TRUE(Eventually([&] { return says("maps: hall (forced)"); }, kPatience));
  ros::param::set("/slam/surroundings", "auto");
  EXPECT_TRUE(Eventually([&] { return says("maps: indoor"); }, kPatience));
  std_srvs::Trigger save;
  ASSERT_TRUE(ros::service::call("/slam/save", save));
  EXPECT_TRUE(save.response.success) << save.response.message;
  const auto first = LoadSlamMap(kMaps);
  ASSERT_TRUE(first) << first.problem();
  EXPECT_GE(first->map.key_frames.size(), 3U);
  // A computer that is busy shows some of them no picture in time.
  EXPECT_TRUE(std::any_of(first->map.key_frames.begin(), first->map.key_frames.end(),
                          [](const auto& key_frame) { return !key_frame->pictures.empty(); }));

  EXPECT_EQ(slam_.Stop(std::chrono::seconds(20)), 0);
  StartSlam("tuesday");
  ASSERT_TRUE(Eventually(
      [&] { return ros::service::call("/slam/save", save) && save.response.success; }, kPatience));
  const Latest<geometry_msgs::PoseStamped> new_pose(node_, "/slam/pose");
  ASSERT_TRUE(
      DriveUntil([&] { return new_pose.get() != nullptr && truth.get()->pose.position.x > 5; }));
  EXPECT_EQ(slam_.Stop(std::chrono::seconds(20)), 0);  // it saves at the end
  const auto second = LoadSlamMap(kMaps);
  ASSERT_TRUE(second) << second.problem();
  EXPECT_EQ(second->map.names.size(), 2U);
  EXPECT_EQ(second->map.names[1].name, "tuesday");

  const std::string log = Temporary("map.log"), plan = Temporary("plan.jpg"),
                    section = Temporary("section.jpg");
  const std::vector<std::string> map = {kPrograms + "coppice-map", kMaps, "--section", section};
  const auto with = [&map](std::vector<std::string> more) {
    more.insert(more.begin(), map.begin(), map.end());
    return more;
  };
  EXPECT_EQ(RunToTheEnd(with({"--plan", plan}), log), 0);
  EXPECT_THAT(TextOf(log), HasSubstr("tuesday"));
  EXPECT_GT(std::filesystem::file_size(plan), 2000U);
  EXPECT_GT(std::filesystem::file_size(section), 2000U);
  EXPECT_EQ(RunToTheEnd(with({"--cut", "y=100"}), log), 1);
  EXPECT_THAT(TextOf(log), HasSubstr("nothing is known there"));
  EXPECT_EQ(RunToTheEnd(with({"--cut", "z=1"}), log), 1);
  EXPECT_THAT(TextOf(log), HasSubstr("expected x=M or y=M, not \"z=1\""));
}

TEST_F(SlamNodeTest, KilledWhileItMapsItHasLostNothing) {
  StartSimulator();
  StartSlam("killed");
  const Latest<diagnostic_msgs::DiagnosticArray> state(node_, "/diagnostics");
  const auto key_frames = [&]() -> std::size_t {
    const auto newest = state.get();
    if (!newest) return 0;
    for (const auto& status : newest->status) {
      if (status.name != "slam: map") continue;
      for (const auto& value : status.values) {
        if (value.key == "key frames") return std::stoul(value.value);
      }
    }
    return 0;
  };
  ASSERT_TRUE(DriveUntil([&] { return key_frames() >= 4; }));
  const std::size_t known = key_frames();
  ASSERT_EQ(::kill(slam_.pid(), SIGKILL), 0);
  slam_.Stop(std::chrono::seconds(20));
  EXPECT_FALSE(LoadSlamMap(kMaps));  // no version was saved
  StartSlam("again");
  std_srvs::Trigger save;
  ASSERT_TRUE(Eventually(
      [&] { return ros::service::call("/slam/save", save) && save.response.success; }, kPatience));
  const auto map = LoadSlamMap(kMaps);
  ASSERT_TRUE(map) << map.problem();
  EXPECT_EQ(map->map.names[0].name, "killed");
  EXPECT_GE(map->map.key_frames.size(), known);
}

// An office that looks like another one to the scanner; the robot stands all the time.
TEST_F(SlamNodeTest, TellsTheLocalizationWhereItIsWhenItWasCarriedBackToWhatItKnows) {
  using State = coppice_msgs::LocalizationState;
  const std::string place = "32.6 -3.25 2.95";
  StartSimulator(place, "false");
  localization_ = ChildProcess({kPrograms + "coppice-localization", "_start_pose:=" + place},
                               Temporary("localization.log"));
  const Latest<State> state(node_, "/localization/state");
  const auto is = [&](int phase) { return state.get() && state.get()->phase == phase; };
  ASSERT_TRUE(Eventually([&] { return is(State::OK); }, kPatience))
      << TextOf(Temporary("localization.log"));
  const Latest<geometry_msgs::PoseStamped> pose(node_, "/slam/pose");
  StartSlam("morning");
  // From the first key frame on it lies on the map that the robot navigates on.
  ASSERT_TRUE(
      Eventually([&] { return pose.get() && pose.get()->header.frame_id == "map"; }, kPatience))
      << TextOf(Temporary("slam.log"));
  EXPECT_NEAR(pose.get()->pose.position.x, 32.6, 0.1);
  EXPECT_NEAR(pose.get()->pose.position.y, -3.25, 0.1);

  Carry("46 0 0");
  ASSERT_TRUE(Eventually([&] { return is(State::LOST); }, kPatience));
  Carry("32.6 -3.2 2.9");
  ASSERT_TRUE(Eventually([&] { return is(State::OK); }, kPatience)) << state.get()->message;
  EXPECT_LT(state.get()->seconds_since_recognized, 5);
  const auto found = ros::topic::waitForMessage<geometry_msgs::PoseWithCovarianceStamped>(
      "/localization/pose", node_, ros::Duration(kPatience));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->pose.pose.position.x, 32.6, 0.1);
  EXPECT_NEAR(found->pose.pose.position.y, -3.25, 0.1);
}

// What is told before anybody listens is lost, and a robot that stands makes no other key frame.
TEST_F(SlamNodeTest, ALocalizationThatIsStartedLaterHearsWhereTheStandingRobotIs) {
  using State = coppice_msgs::LocalizationState;
  const std::string place = "-0.7 0 3.14159";  // before the poster above the station
  StartSimulator(place, "false");
  const std::vector<std::string> localization = {kPrograms + "coppice-localization",
                                                 "_start_pose:=" + place};
  localization_ = ChildProcess(localization, Temporary("localization.log"));
  const Latest<geometry_msgs::PoseStamped> pose(node_, "/slam/pose");
  StartSlam("morning");
  const auto is_on_map = [&] { return pose.get() && pose.get()->header.frame_id == "map"; };
  ASSERT_TRUE(Eventually(is_on_map, kPatience)) << TextOf(Temporary("slam.log"));
  EXPECT_EQ(slam_.Stop(std::chrono::seconds(20)), 0);
  EXPECT_EQ(localization_.Stop(std::chrono::seconds(20)), 0);

  StartSlam("afternoon");
  std_srvs::Trigger save;
  const auto has_both = [&] {
    const auto map = ros::service::call("/slam/save", save) ? LoadSlamMap(kMaps)
                                                            : Expected<LoadedMap>(Problem{""});
    return map && map->map.names.size() == 2;
  };
  ASSERT_TRUE(Eventually(has_both, kPatience)) << TextOf(Temporary("slam.log"));
  localization_ = ChildProcess(localization, Temporary("localization.log"));
  const Latest<State> state(node_, "/localization/state");
  EXPECT_TRUE(Eventually([&] { return state.get() && state.get()->seconds_since_recognized < 1e6; },
                         kPatience))
      << TextOf(Temporary("localization.log"));
}

TEST_F(SlamNodeTest, RefusesWhatMakesNoSense) {
  const std::string log = Temporary("refused.log"), slam = kPrograms + "coppice-slam";
  EXPECT_EQ(RunToTheEnd({slam, "__name:=a", "_surroundings:=cellar"}, log), 2);
  EXPECT_THAT(TextOf(log), HasSubstr("expected auto, indoor, hall or outdoor"));
  EXPECT_EQ(RunToTheEnd({slam, "__name:=c", "_mapping:=perhaps"}, log), 2);
  EXPECT_THAT(TextOf(log), HasSubstr("expected yes or no, not \"perhaps\""));
  EXPECT_EQ(RunToTheEnd({slam, "__name:=b", "_vocabulary:=/nowhere"}, log), 2);
  EXPECT_THAT(TextOf(log), HasSubstr("/nowhere: cannot be read"));
  EXPECT_EQ(RunToTheEnd({kPrograms + "coppice-map", "/nowhere"}, log), 1);
  EXPECT_THAT(TextOf(log), HasSubstr("/nowhere"));
}

}  // namespace
}  // namespace coppice::robot::slam
