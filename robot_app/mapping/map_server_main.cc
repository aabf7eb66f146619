// coppice-map-server: the node /map_server, which shows a saved map to all others.
#include <nav_msgs/OccupancyGrid.h>
#include <ros/names.h>
#include <ros/ros.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include "robot_app/common/ros_support.h"
#include "robot_app/mapping/map_file.h"
#include "robot_app/mapping/map_message.h"

namespace coppice::robot::mapping {
namespace {

constexpr char kHelp[] =
    "coppice-map-server: shows a saved map, as the ROS node /map_server.\n"
    "  publishes   /map (nav_msgs/OccupancyGrid, latched)\n"
    "As long as the file is not there it passes on the maps of ~stand_in_topic. Exit status 2\n"
    "also if the file is no map, or there is neither.\n";

struct Settings {
  std::string map = "none";
  std::string stand_in_topic = "none";
  std::string frame = "map";
};

Parameters ParametersOf(Settings& settings) {
  return {{"map", &settings.map, "the YAML file of the map"},
          {"stand_in_topic", &settings.stand_in_topic, "as long as it is not there"},
          {"map_frame", &settings.frame, "the frame of the map"}};
}

int Fail(const std::string& reason) {
  std::fprintf(stderr, "map_server: %s\n", reason.c_str());
  return 2;
}

int Run(const Settings& settings) {
  const std::string& file = settings.map;
  ros::NodeHandle node;
  const ros::Publisher publisher = node.advertise<nav_msgs::OccupancyGrid>("/map", 1, true);
  ros::Subscriber subscriber;
  std::error_code error;
  if (file != "none" && std::filesystem::exists(file, error)) {
    Diagnostics diagnostics;
    const std::optional<OccupancyGrid> map = LoadMap(file, diagnostics);
    if (!map) return Fail(diagnostics.ToString());
    publisher.publish(ToMessage(*map, settings.frame, ros::Time::now()));
    ROS_INFO("shows %s", file.c_str());
  } else if (settings.stand_in_topic != "none") {
    std::string problem;
    if (!ros::names::validate(settings.stand_in_topic, problem)) {
      return Fail("~stand_in_topic: " + problem);
    }
    subscriber = node.subscribe<nav_msgs::OccupancyGrid>(
        settings.stand_in_topic, 1,
        [publisher](const nav_msgs::OccupancyGrid::ConstPtr& map) { publisher.publish(map); });
    ROS_INFO("there is no map in %s yet; passes on %s", file.c_str(),
             settings.stand_in_topic.c_str());
  } else {
    return Fail("there is no map in " + file + " (~map)");
  }
  ros::spin();
  return 0;
}

}  // namespace
}  // namespace coppice::robot::mapping

int main(int argc, char** argv) {
  using namespace coppice::robot::mapping;  // NOLINT: the whole program
  return coppice::robot::RunNode<Settings>(argc, argv, "map_server", kHelp, Run);
}
