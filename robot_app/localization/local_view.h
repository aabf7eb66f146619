// What the robot has seen around itself since it began to look: scans of several headings and
// places, put together by odometry.
#ifndef COPPICE_ROBOT_APP_LOCALIZATION_LOCAL_VIEW_H_
#define COPPICE_ROBOT_APP_LOCALIZATION_LOCAL_VIEW_H_

#include <deque>
#include <vector>

#include "robot_app/localization/beams.h"

namespace coppice::robot::localization {

class LocalView {
 public:
  /// Forgets everything. To be called when the odometry has another frame, or the robot may have
  /// been carried away since.
  void Clear();

  /// A scan's beams, taken at `odometry`. Kept if the robot has turned or moved since the last one
  /// that was kept; true then.
  bool Add(const Pose2D& odometry, const std::vector<Beam>& beams);

  bool empty() const { return looks_.empty(); }
  /// The robot has turned or moved so much that it has seen everything around it.
  bool complete() const;
  /// All beams as seen from `odometry`.
  std::vector<Beam> From(const Pose2D& odometry) const;

 private:
  struct Look {
    Pose2D odometry;
    std::vector<Beam> beams;
  };
  std::deque<Look> looks_;
  double turned_ = 0;  // rad
  double moved_ = 0;   // m
};

}  // namespace coppice::robot::localization

#endif  // COPPICE_ROBOT_APP_LOCALIZATION_LOCAL_VIEW_H_
