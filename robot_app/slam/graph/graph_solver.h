// Solves a pose graph in parts of bounded size, so that a closure takes no longer in a large map
// than in a small one.
//
// A closure that is far off is spread over groups of key frames first (coarse_graph.h). Then the
// poses around it are solved, with those around them held. A part that has moved makes what is
// bound to it rough; what is rough is solved later, a part at a time (Refine), and the groups again
// when nothing is, until nothing moves any more: very nearly to where all poses lie if they are
// solved at once. Small maps are one part.
//
// All is deterministic: the same calls give the same poses.
#ifndef COPPICE_ROBOT_APP_SLAM_GRAPH_GRAPH_SOLVER_H_
#define COPPICE_ROBOT_APP_SLAM_GRAPH_GRAPH_SOLVER_H_

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "robot_app/slam/graph/coarse_graph.h"
#include "robot_app/slam/graph/pose_graph.h"

namespace coppice::robot::slam {

struct SolverSettings {
  OptimizeSettings optimize;
  CoarseSettings coarse;
  std::size_t part_poses = 200;  ///< of a part that is solved at once,
  std::size_t part_links = 800;  ///< and what binds them
  double still = 0.002;          ///< what moves less leaves its neighbours as they are [m],
  double still_turn = 0.0005;    ///< and [rad]
};

/// What Ceres was asked to calculate, to be held against the bounds.
struct SolverWork {
  std::size_t poses = 0;
  std::size_t links = 0;
};

/// Of one graph, of which it hears. Not thread-safe.
class GraphSolver {
 public:
  explicit GraphSolver(SolverSettings settings = {}) : settings_(settings) {}

  /// The graph has one more pose, or one more link.
  void AddPose();
  void AddLink(const PoseGraph& graph);
  /// The newest link is about to be taken back.
  void DropLink(const PoseGraph& graph);

  /// Moves all poses, in groups, to where they fit the links and the closures best, which need not
  /// be links yet. The poses `fixed`, ascending, stay in all these.
  bool SolveCoarse(const std::vector<std::uint32_t>& fixed, const std::vector<Link>& closures,
                   PoseGraph& graph);

  /// Moves what is around some poses.
  bool SolveAround(const std::vector<std::uint32_t>& poses, const std::vector<std::uint32_t>& fixed,
                   PoseGraph& graph);

  /// Moves a part of what is rough, or the groups. False: all is settled.
  bool Refine(const std::vector<std::uint32_t>& fixed, PoseGraph& graph);

  /// Of each pose, whether Refine has it before it; to be set when poses are taken back.
  const std::vector<bool>& rough() const { return is_rough_; }
  void SetRough(std::vector<bool> rough) { is_rough_ = std::move(rough); }

  /// Since it was asked for the last time.
  SolverWork TakeWork();

 private:
  std::vector<std::uint32_t> PartAround(const std::vector<std::uint32_t>& seeds, bool rough_first,
                                        const PoseGraph& graph) const;
  bool SolvePart(const std::vector<std::uint32_t>& part, const std::vector<std::uint32_t>& fixed,
                 PoseGraph& graph);
  bool Solve(const std::vector<std::uint32_t>& fixed, PoseGraph& graph);
  bool IsStill(const Pose3& before, const Pose3& after) const;

  SolverSettings settings_;
  std::vector<std::vector<std::uint32_t>> links_of_;  // of each pose, as indices of the graph's
  std::vector<bool> is_rough_;
  bool is_coarse_due_ = false;  // something has moved since the groups were solved
  SolverWork work_;
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_GRAPH_GRAPH_SOLVER_H_
