// coppice-map-server: the node /map_server, which shows a saved map to all others.
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "robot_app/common/ros_support.h"
#include "robot_app/mapping/map_file.h"
#include "robot_app/mapping/map_message.h"

namespace coppice::robot::mapping {
namespace {

constexpr char kHelp[] =
    "coppice-map-server: shows a saved map, as the ROS node /map_server.\n"
    "  publishes   /map (nav_msgs/OccupancyGrid, latched)\n"
    "  parameters  ~map FILE: the YAML file of the map, as coppice-mapping and map_server write "
    "it\n"
    "    ~stand_in_topic TOPIC: where to take a map from as long as there is no such file. "
    "Default:\n"
    "      none; then the file must be there\n"
    "    ~map_frame map\n"
    "Ends on SIGTERM and SIGINT. Exit status 2: the file is no map, or there is neither; no ROS\n"
    "master answers; a parameter is wrong.\n";

int Fail(const std::string& reason) {
  std::fprintf(stderr, "map_server: %s\n", reason.c_str());
  return 2;
}

int Run() {
  Parameters parameters;
  const std::string file = parameters.Text("map", "none");
  const std::string stand_in = parameters.Text("stand_in_topic", "none");
  const std::string frame = parameters.Text("map_frame", "map");
  if (!parameters.Finish()) return 2;
  ros::NodeHandle node;
  const ros::Publisher publisher = node.advertise<nav_msgs::OccupancyGrid>("/map", 1, true);
  ros::Subscriber subscriber;
  if (file != "none" && std::filesystem::exists(file)) {
    Diagnostics diagnostics;
    const std::optional<OccupancyGrid> map = LoadMap(file, diagnostics);
    if (!map) return Fail(diagnostics.ToString());
    publisher.publish(ToMessage(*map, frame, ros::Time::now()));
    ROS_INFO("shows %s", file.c_str());
  } else if (stand_in != "none") {
    subscriber = node.subscribe<nav_msgs::OccupancyGrid>(
        stand_in, 1,
        [publisher](const nav_msgs::OccupancyGrid::ConstPtr& map) { publisher.publish(map); });
    ROS_INFO("there is no map in %s yet; passes on %s", file.c_str(), stand_in.c_str());
  } else {
    return Fail("there is no map in " + file + " (~map)");
  }
  ros::spin();
  return 0;
}

}  // namespace
}  // namespace coppice::robot::mapping

int main(int argc, char** argv) {
  namespace robot = coppice::robot;
  if (const auto status = robot::StartNode(argc, argv, "map_server", robot::mapping::kHelp))
    return *status;
  return robot::mapping::Run();
}
