// The pose graph of many sessions: who drove when, which closures are believed, and which sessions
// lie in one map.
//
// A session begins anywhere, unknown to those before it; its poses are given in a frame of its own,
// which begins where it began. A closure between two sessions that have nothing in common is not
// believed alone, for nothing could contradict it: it waits until a second one, measured some way
// from it, says the same of how both lie to each other. Then the younger session is moved into the
// frame of the older one. A closure inside of one map is believed if it fits, and makes none
// unfit, once the poses have been moved to where they fit best; else it is forgotten and nothing
// has moved. However large the map is, that takes no longer (graph_solver.h).
//
//   SessionGraph graph(settings);
//   graph.BeginSession();
//   const std::uint32_t key_frame = graph.AddPose(moved, information);
//   if (graph.AddClosure(link) == Verdict::kBelieved) ...   // graph.poses() have moved
//   graph.Refine();                                         // and move on a little
//
// M. Labbe, F. Michaud: RTAB-Map as an Open-Source Lidar and Visual SLAM Library, Journal of Field
// Robotics 36 (2019): multi-session mapping, closures refused by the error that they leave.
#ifndef COPPICE_ROBOT_APP_SLAM_GRAPH_SESSION_GRAPH_H_
#define COPPICE_ROBOT_APP_SLAM_GRAPH_SESSION_GRAPH_H_

#include <cstdint>
#include <vector>

#include "robot_app/slam/graph/graph_solver.h"
#include "robot_app/slam/graph/pose_graph.h"

namespace coppice::robot::slam {

struct SessionGraphSettings {
  SolverSettings solver;
  /// How well odometry knows the robot to be upright or tilted [rad, standard deviation]: by
  /// gravity if it measures that, else because the robot drives on level floors.
  double tilt = 0.005;
  /// A closure that is off by no more, squared in standard deviations, moves nothing: the graph as
  /// it is fits it.
  double settled = 4;
  /// A closure that is farther off than this afterwards, squared in standard deviations, is false.
  double most_error = 30;
  /// So many times that is allowed where a part of the map is not solved to the end yet.
  double while_rough = 2;
  // Two closures that are to join sessions.
  double apart = 0.7;         ///< at least so far from each other, for both sessions [m]
  double most_off = 0.3;      ///< they say the same to within [m],
  double most_turned = 0.06;  ///< and [rad]
};

enum class Verdict {
  kBelieved,  ///< it counts, and poses may have moved
  kWaits,     ///< it would join two maps and nobody has said the same yet
  kRefused    ///< it contradicts what is known
};

/// Not thread-safe.
class SessionGraph {
 public:
  explicit SessionGraph(SessionGraphSettings settings = {})
      : settings_(settings), solver_(settings.solver) {}

  /// A graph as it was written down; `sessions` is the session of each pose, from 0 on, ascending.
  SessionGraph(SessionGraphSettings settings, PoseGraph graph, std::vector<std::uint32_t> sessions);

  /// The next pose is the first of a new session, which knows nothing of the others.
  void BeginSession() { begins_ = true; }

  /// A key frame `moved` from the one before it; the first of a session is the origin of its frame,
  /// and upright. Returns its index.
  std::uint32_t AddPose(const Pose3& moved, const Matrix6& information);

  /// Is measured between two poses; see above.
  Verdict AddClosure(const Link& closure);

  /// Moves what the closures before have left rough, a part of it; to be called at each key frame.
  /// False: all is settled.
  bool Refine() { return solver_.Refine(FirstPoses(), graph_); }

  /// What was calculated since this was asked.
  SolverWork TakeWork() { return solver_.TakeWork(); }

  const std::vector<Pose3>& poses() const { return graph_.poses; }
  const PoseGraph& graph() const { return graph_; }
  /// Of each pose.
  const std::vector<std::uint32_t>& sessions() const { return sessions_; }
  std::uint32_t session_count() const { return static_cast<std::uint32_t>(maps_.size()); }
  /// The map in whose frame a session's poses are: the oldest session that it is joined with.
  std::uint32_t map_of(std::uint32_t session) const { return maps_[session]; }
  bool InOneMap(std::uint32_t pose, std::uint32_t other) const;

 private:
  void AddFirst(const Pose3& pose);
  void AddNext(const Pose3& pose, const Pose3& moved);
  void AddPose(const Pose3& pose);
  Verdict CloseInside(const std::vector<Link>& closures);
  bool SolveAround(const std::vector<Link>& closures);
  bool AllFit(const std::vector<Link>& closures, double most) const;
  Verdict Join(const Link& closure);
  void MoveMap(std::uint32_t from, std::uint32_t to, const Pose3& motion);
  bool SaysTheSame(const Link& closure, const Link& other) const;
  std::vector<std::uint32_t> FirstPoses() const;

  SessionGraphSettings settings_;
  PoseGraph graph_;
  GraphSolver solver_;
  std::vector<std::uint32_t> sessions_;                     // of each pose
  std::vector<std::uint32_t> maps_;                         // of each session
  std::vector<Link> waiting_;                               // between maps
  Eigen::Matrix3d odometry_ = Eigen::Matrix3d::Identity();  // how the newest pose is turned in it
  bool begins_ = true;
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_GRAPH_SESSION_GRAPH_H_
