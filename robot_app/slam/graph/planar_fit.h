// Points on the floor laid upon others.
#ifndef COPPICE_ROBOT_APP_SLAM_GRAPH_PLANAR_FIT_H_
#define COPPICE_ROBOT_APP_SLAM_GRAPH_PLANAR_FIT_H_

#include <vector>

#include "robot_app/slam/graph/pose_graph.h"

namespace coppice::robot::slam {

/// The shift, and the turn about z, that lay points `b` upon points `a` best (least squares of the
/// distances); both of one length. S. Umeyama, PAMI 13 (1991), in the plane.
Pose3 PlanarFit(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_GRAPH_PLANAR_FIT_H_
