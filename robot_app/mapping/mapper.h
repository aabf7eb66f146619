// Makes a map while somebody drives the robot about: simultaneous localization and mapping with a
// planar laser.
//
// Every so often a scan is kept, a *key frame*. It is matched with what the key frames before it
// have seen (scan_matcher.h) and bound to the one before by that and by odometry. When the robot
// comes back to where it was, the loop is closed (loop_closure.h), and all poses are moved so that
// everything that was measured fits best (pose_graph.h). The map is what the key frames have seen
// from their poses (log_odds_grid.h). The scheme is that of K. Konolige et al.: Efficient Sparse
// Pose Adjustment for 2D Mapping (IROS 2010), the search that of W. Hess et al.: Real-Time Loop
// Closure in 2D LIDAR SLAM (ICRA 2016).
//
// Deterministic, without a clock, a thread or ROS. Stamps in seconds of any one clock.
#ifndef COPPICE_ROBOT_APP_MAPPING_MAPPER_H_
#define COPPICE_ROBOT_APP_MAPPING_MAPPER_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/localization/pose_history.h"
#include "robot_app/mapping/key_frame.h"
#include "robot_app/mapping/log_odds_grid.h"
#include "robot_app/mapping/pose_graph.h"

namespace coppice::robot::mapping {

struct MappingReport {
  std::size_t key_frames = 0;
  std::size_t loops = 0;  ///< that were closed
  double way = 0;         ///< that was driven [m]
  double score = 0;       ///< how well the newest key frame fits those before it, 0..1
  bool fits = true;       ///< it does
  std::string message;    ///< for people
};

class Mapper {
 public:
  /// The robot stands at `start` in the map frame when the first scan comes.
  explicit Mapper(MappingSettings settings = {}, const Pose2D& start = {});

  /// base_link in the odometry frame. If the frame itself has jumped (its source was restarted) the
  /// robot is believed to stand about where it stood before.
  void AddOdometry(double stamp, const Pose2D& pose);
  /// A scan is used once odometry is known for its time; a newer one replaces a waiting one. Most
  /// take no time, a key frame some 30 ms, a closed loop up to a second.
  void AddScan(LaserScan scan);

  bool started() const { return frames_.size() > 0; }
  /// base_link in the map frame at the time of the last scan.
  Pose2D pose() const { return Compose(frames_.poses.back(), RelativeTo(at_frame_, odometry_)); }
  /// The pose of the odometry frame in the map.
  Pose2D odom_in_map() const {
    return Compose(frames_.poses.back(), RelativeTo(at_frame_, Pose2D{}));
  }
  double scan_stamp() const { return stamp_; }
  /// Grows with every change of the map.
  std::size_t revision() const { return revision_; }
  OccupancyGrid Map() const { return grid_.ToMap(); }
  MappingReport Report() const;

 private:
  void UseWaiting();
  bool IsFarEnough() const;
  void AddKeyFrame(const LaserScan& scan);
  const localization::LikelihoodField& SeenLately();
  PoseConstraint MatchWithLast(const LaserScan& scan, const Pose2D& moved);
  void LookForLoop();
  void Draw();

  MappingSettings settings_;
  Pose2D start_;
  localization::PoseHistory history_;
  std::optional<LaserScan> waiting_;
  KeyFrames frames_;
  std::vector<PoseConstraint> constraints_;
  std::unique_ptr<localization::LikelihoodField> lately_;  // what was seen on the last stretch
  std::size_t lately_end_ = 0;                             // by the key frames before that one
  LogOddsGrid grid_;
  std::vector<Pose2D> drawn_;  // the poses from which the key frames are in the grid

  double stamp_ = 0;
  Pose2D odometry_;         // at stamp_
  Pose2D at_frame_;         // odometry at the newest key frame
  int odometry_frame_ = 0;  // of the history, at stamp_
  bool jumped_ = false;     // the odometry, since the newest key frame
  double way_ = 0;
  double closed_at_ = 0;  // the way at the last closed loop
  std::size_t loops_ = 0;
  double score_ = 1;
  bool too_large_ = false;
  std::size_t revision_ = 0;
};

}  // namespace coppice::robot::mapping

#endif  // COPPICE_ROBOT_APP_MAPPING_MAPPER_H_
