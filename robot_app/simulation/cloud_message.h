// A cloud of the 3-D lidar as ROS sends it.
#ifndef COPPICE_ROBOT_APP_SIMULATION_CLOUD_MESSAGE_H_
#define COPPICE_ROBOT_APP_SIMULATION_CLOUD_MESSAGE_H_

#include <sensor_msgs/PointCloud2.h>

#include "robot_app/simulation/lidar_3d.h"

namespace coppice::robot::simulation {

/// Fields and layout of the Velodyne driver (velodyne_pointcloud, PointXYZIRT): x y z intensity
/// (float32), ring (uint16), time (float32, s since the header's stamp); one row for each ring,
/// from the lowest, one column for each direction. A ray that met nothing has NaN in x, y and z.
/// The header is left to the caller.
sensor_msgs::PointCloud2 ToMessage(const Cloud& cloud, int rings);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_CLOUD_MESSAGE_H_
