#include "robot_app/mapping/map_message.h"

namespace coppice::robot::mapping {

nav_msgs::OccupancyGrid ToMessage(const OccupancyGrid& map, const std::string& frame,
                                  const ros::Time& stamp) {
  nav_msgs::OccupancyGrid message;
  message.header.stamp = stamp;
  message.header.frame_id = frame;
  message.info.map_load_time = stamp;
  message.info.resolution = static_cast<float>(map.frame.resolution);
  message.info.width = static_cast<std::uint32_t>(map.frame.width);
  message.info.height = static_cast<std::uint32_t>(map.frame.height);
  message.info.origin.position.x = map.frame.origin_x;
  message.info.origin.position.y = map.frame.origin_y;
  message.info.origin.orientation.w = 1;
  message.data = map.cells;
  return message;
}

}  // namespace coppice::robot::mapping
