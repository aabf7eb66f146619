// What the robot has learnt of the ways between its places, for RViz: a line for each edge, which
// keeps to the right of its direction, and what it knows of it in words.
//
//   grey    not travelled yet       green   takes what was expected, or little more
//   red     blocked                 orange  takes longer
#ifndef COPPICE_ROBOT_APP_ROS_WAY_MARKERS_H_
#define COPPICE_ROBOT_APP_ROS_WAY_MARKERS_H_

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "robot_app/common/places/edge_memory.h"

namespace coppice::robot::adapters {

/// The first marker has the lines, the others the words. Edges that lead elsewhere are left out.
visualization_msgs::MarkerArray MarkersOf(const TopologicalMap& map, const EdgeMemory& memory,
                                          Time now, const std::string& frame);

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_WAY_MARKERS_H_
