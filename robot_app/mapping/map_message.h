// Maps as ROS sends them.
#ifndef COPPICE_ROBOT_APP_MAPPING_MAP_MESSAGE_H_
#define COPPICE_ROBOT_APP_MAPPING_MAP_MESSAGE_H_

#include <nav_msgs/OccupancyGrid.h>

#include <string>

#include "robot_app/common/occupancy_grid.h"

namespace coppice::robot::mapping {

/// `frame`: the name of the map frame.
nav_msgs::OccupancyGrid ToMessage(const OccupancyGrid& map, const std::string& frame,
                                  const ros::Time& stamp);

}  // namespace coppice::robot::mapping

#endif  // COPPICE_ROBOT_APP_MAPPING_MAP_MESSAGE_H_
