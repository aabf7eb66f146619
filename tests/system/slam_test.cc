// The shipped configuration with slam=yes: it maps in three dimensions beside all else, is watched
// and restarted, its map outlives it, tells the localization where the robot is, and becomes the
// map that the robot works with.
#include <coppice_msgs/LocalizationState.h>
#include <coppice_msgs/RestartProcess.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/GetPlan.h>
#include <nav_msgs/OccupancyGrid.h>
#include <std_srvs/Trigger.h>

#include <cmath>
#include <csignal>

#include "robot_app/mapping/map_file.h"
#include "robot_app/slam/map/slam_map_file.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/latest.h"
#include "tests/robot_app/mapping/map_quality.h"
#include "tests/robot_app/navigation/world_robot.h"
#include "tests/robot_app/text_of.h"
#include "tests/support/folders.h"
#include "tests/system/driver.h"
#include "tests/system/robot_rig.h"

namespace coppice::robot {
namespace {

using coppice_msgs::LocalizationState;

constexpr double kPatience = 60;  // s, wall

RigOptions Options() {
  RigOptions options;
  options.name = "slam";
  options.start = "1 0 3.14159";
  options.variables = {{"slam", "yes"},
                       {"speed", "2"},
                       {"seed", "7"},
                       {"session", "morning"},
                       {"application", SourceFolder() + "/tests/system/trees/stand.xml"}};
  return options;
}

TEST(Slam, MapsBesideAllElseOutlivesItsEndAndItsMapIsWorkedWith) {
  RobotRig rig(Options());
  ASSERT_TRUE(rig.Start());
  const int pid = rig.With([](const RobotState& state) { return state.ReadyPid("slam"); });
  ASSERT_NE(pid, 0);
  EXPECT_EQ(rig.With([](const RobotState& state) { return state.Level("node", "/slam"); }), 0);

  Driver driver;
  ASSERT_TRUE(driver.Drive({{-0.8, 0}, {2.2, 0}, {-0.7, 0}}, kPatience));
  std_srvs::Trigger save;
  ASSERT_TRUE(ros::service::call("/slam/save", save));
  ASSERT_TRUE(save.response.success) << save.response.message;
  const std::string maps = (rig.folder() / "institute/slam").string();
  const auto saved = slam::LoadSlamMap(maps);
  ASSERT_TRUE(saved) << saved.problem();

  ros::NodeHandle node;
  const Latest<LocalizationState> localized(node, "/localization/state");
  const double killed = rig.Now().ros;
  ASSERT_TRUE(rig.Signal("slam", SIGKILL));
  ASSERT_TRUE(rig.WaitFor(
      [pid](const RobotState& state) {
        return state.ReadyPid("slam") != 0 && state.ReadyPid("slam") != pid;
      },
      kPatience))
      << rig.TimelineSince({});
  ASSERT_TRUE(rig.WaitUntilNominal(kPatience).has_value());
  // Standing before the poster above the station it recognizes the place at once, and the
  // localization hears of it.
  EXPECT_TRUE(Eventually(
      [&] {
        return localized.get() &&
               localized.get()->header.stamp.toSec() - localized.get()->seconds_since_recognized >
                   killed;
      },
      kPatience))
      << rig.Logged("slam");
  ASSERT_TRUE(ros::service::call("/slam/save", save));
  ASSERT_TRUE(save.response.success) << save.response.message;
  const auto kept = slam::LoadSlamMap(maps);
  ASSERT_TRUE(kept) << kept.problem();
  // More than two: on a busy computer the robot has restarted its simulator, and time began anew.
  ASSERT_EQ(kept->map.names.size(), saved->map.names.size() + 1);
  EXPECT_EQ(kept->map.names.front().name, "morning");
  EXPECT_EQ(kept->map.names.back().name, "morning");
  EXPECT_TRUE(kept->map.key_frames.front()->place.has_value());

  // The grid of the map, where it lay, becomes the map that it works with.
  const std::string grid = (rig.folder() / "institute/map.yaml").string();
  ChildProcess write({BinaryFolder() + "/bin/coppice-map", maps, "--grid", grid},
                     rig.log("write_grid").string());
  ASSERT_TRUE(Eventually([&] { return !write.IsRunning(); }, kPatience));
  ASSERT_EQ(write.exit_status(), 0) << rig.Logged("write_grid");
  Diagnostics diagnostics;
  const auto map = mapping::LoadMap(grid, diagnostics);
  ASSERT_TRUE(map) << diagnostics.ToString();
  const OccupancyGrid floor = navigation::MapOf(navigation::InstituteFloor());
  EXPECT_GT(mapping::ShareNear(floor, *map, 0.15, {-2.5, -1.4}, {6, 1.4}), 0.9);
  coppice_msgs::RestartProcess restart;
  restart.request.name = "map_server";
  ASSERT_TRUE(ros::service::call("/supervisor/restart", restart));
  ASSERT_TRUE(restart.response.ok) << restart.response.message;
  const Latest<nav_msgs::OccupancyGrid> shown(node, "/map");
  EXPECT_TRUE(
      Eventually([&] { return shown.get() && shown.get()->data == map->cells; }, kPatience));
  ASSERT_TRUE(rig.WaitUntilNominal(kPatience).has_value());
  ASSERT_TRUE(driver.Drive({{0.3, 0}}, kPatience));
  const double there = rig.Now().ros;
  ASSERT_TRUE(rig.WaitFor([there](const RobotState& state) { return state.compared_at() > there; },
                          kPatience));
  EXPECT_LT(rig.With([](const RobotState& state) { return state.deviation(); }), 0.2);
  nav_msgs::GetPlan plan;
  plan.request.goal.header.frame_id = "map";
  plan.request.goal.pose = ToPoseMessage(Pose2D{4, 0, 0});
  ASSERT_TRUE(ros::service::call("move_base/make_plan", plan));
  EXPECT_FALSE(plan.response.plan.poses.empty());
}

}  // namespace
}  // namespace coppice::robot
