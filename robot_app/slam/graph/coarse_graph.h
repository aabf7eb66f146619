// A pose graph in few poses: key frames that lie in one square of the floor and are bound to each
// other there move as one, and all links between two such groups become one. What a loop of half a
// kilometre is off is spread over the groups in no more time than over a small loop; what is left
// inside of them is little, and is solved part by part (session_graph.h).
//
// However many sessions went through a building, it has the same squares.
//
// C. Estrada, J. Neira, J. D. Tardos: Hierarchical SLAM: Real-Time Accurate Mapping of Large
// Environments, IEEE T-RO 21 (2005). G. Grisetti, R. Kuemmerle, C. Stachniss, U. Frese, C.
// Hertzberg: Hierarchical Optimization on Manifolds for Online 2D and 3D Mapping, ICRA 2010.
#ifndef COPPICE_ROBOT_APP_SLAM_GRAPH_COARSE_GRAPH_H_
#define COPPICE_ROBOT_APP_SLAM_GRAPH_COARSE_GRAPH_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "robot_app/slam/graph/pose_graph.h"

namespace coppice::robot::slam {

struct CoarseGraph {
  /// Of each pose of the graph that it was made of.
  std::vector<std::uint32_t> group_of;
  /// Pose i is that of the first key frame of group i. What binds two groups is a step: closures
  /// that are in doubt count for less already. A group is upright as its key frames are together.
  PoseGraph graph;
};

struct CoarseSettings {
  double square = 4;  ///< edge of a square [m], doubled until there are few enough groups
  std::size_t most_groups = 250;
  OptimizeSettings optimize;
  double most_error = 30;  ///< a closure that is farther off binds nothing, squared
};

CoarseGraph MakeCoarse(const PoseGraph& graph, const CoarseSettings& settings);

/// A closure between two poses, as one between their groups.
Link BetweenGroups(const CoarseGraph& coarse, const std::vector<Pose3>& poses, const Link& link);

/// Moves the poses with their groups, which were at `before`.
void MoveWithGroups(const CoarseGraph& coarse, const std::vector<Pose3>& before,
                    std::vector<Pose3>& poses);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_GRAPH_COARSE_GRAPH_H_
