// A person makes a map: the configuration is set by hand, the robot driven as the page drives it,
// the map saved; then the robot works with it. At six times real time.
#include <coppice_msgs/SetConfiguration.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <std_srvs/Trigger.h>

#include "robot_app/mapping/map_file.h"
#include "tests/robot_app/mapping/map_quality.h"
#include "tests/robot_app/navigation/world_robot.h"
#include "tests/support/folders.h"
#include "tests/system/driver.h"
#include "tests/system/robot_rig.h"

namespace coppice::robot {
namespace {

constexpr double kPatience = 60;  // s, wall

RigOptions Options() {
  RigOptions options;
  options.name = "mapping";
  options.start = "0 0 0";
  options.variables = {{"speed", "6"},
                       {"seed", "5"},
                       {"application", SourceFolder() + "/tests/system/trees/stand.xml"}};
  return options;
}

bool SetConfiguration(const std::string& name, bool by_hand) {
  coppice_msgs::SetConfiguration service;
  service.request.configuration = name;
  service.request.manual = by_hand;
  if (!ros::service::call("/supervisor/set_configuration", service)) return false;
  EXPECT_TRUE(service.response.ok) << service.response.message;
  return service.response.ok;
}

bool RunsAs(RobotRig& rig, const std::string& configuration, const std::string& with,
            const std::string& without) {
  return rig.WaitFor(
      [&](const RobotState& state) {
        return state.configuration() == configuration && state.ReadyPid(with) != 0 &&
               state.Pid(without) == 0;
      },
      kPatience);
}

TEST(Mapping, APersonDrivesAMapAndTheRobotWorksWithIt) {
  RobotRig rig(Options());
  ASSERT_TRUE(rig.Start());
  ASSERT_TRUE(SetConfiguration("mapping", true));
  ASSERT_TRUE(RunsAs(rig, "mapping", "mapping", "localization"));
  ASSERT_TRUE(rig.WaitUntilNominal(kPatience).has_value());
  EXPECT_EQ(rig.With([](const RobotState& state) { return state.Pid("navigation"); }), 0);
  EXPECT_EQ(rig.With([](const RobotState& state) { return state.Pid("docking"); }), 0);

  Driver driver;
  ASSERT_TRUE(driver.Drive({{8, 0}, {8, 2.8}, {8, 0}, {11.5, 0}, {3, 0}}, 2 * kPatience));
  // Nothing but that it is not the page that drives.
  EXPECT_THAT(rig.With([](const RobotState& state) { return state.Problems(); }),
              testing::Each(testing::StartsWith("publisher /cmd_vel/supervisor: ")));
  std_srvs::Trigger save;
  ASSERT_TRUE(ros::service::call("/mapping/save", save));
  ASSERT_TRUE(save.response.success) << save.response.message;

  Diagnostics diagnostics;
  const auto map = mapping::LoadMap((rig.folder() / "institute/map.yaml").string(), diagnostics);
  ASSERT_TRUE(map) << diagnostics.ToString();
  const OccupancyGrid floor = navigation::MapOf(navigation::InstituteFloor());
  EXPECT_GT(mapping::ShareNear(*map, floor, 0.15), 0.95);
  EXPECT_GT(mapping::ShareNear(floor, *map, 0.15, {-2.5, -1.4}, {12, 1.4}), 0.9);

  // The trees leave it as it is when the person lets go; who asked for it asks for the next one.
  std_srvs::Trigger release;
  ASSERT_TRUE(ros::service::call("/supervisor/release", release));
  ASSERT_TRUE(rig.WaitUntilNominal(kPatience).has_value());
  EXPECT_EQ(rig.With([](const RobotState& state) { return state.configuration(); }), "mapping");
  ASSERT_TRUE(SetConfiguration("operating", false));
  ASSERT_TRUE(RunsAs(rig, "operating", "localization", "mapping"));
  ASSERT_TRUE(rig.WaitUntilNominal(kPatience).has_value());
  const auto shown =
      ros::topic::waitForMessage<nav_msgs::OccupancyGrid>("/map", ros::Duration(240));
  ASSERT_TRUE(shown);
  EXPECT_TRUE(shown->data == map->cells);

  // The robot knows where it is on its own map, and goes on knowing.
  ASSERT_TRUE(driver.Drive({{6, 0}}, kPatience));
  const double there = rig.Now().ros;
  ASSERT_TRUE(rig.WaitFor([there](const RobotState& state) { return state.compared_at() > there; },
                          kPatience));
  EXPECT_LT(rig.With([](const RobotState& state) { return state.deviation(); }), 0.2);
  EXPECT_TRUE(rig.WaitUntilNominal(kPatience).has_value());
}

}  // namespace
}  // namespace coppice::robot
