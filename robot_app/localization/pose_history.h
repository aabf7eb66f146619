// The odometry of the last seconds, to know where the robot was when a scan was taken.
#ifndef COPPICE_ROBOT_APP_LOCALIZATION_POSE_HISTORY_H_
#define COPPICE_ROBOT_APP_LOCALIZATION_POSE_HISTORY_H_

#include <deque>
#include <optional>

#include "robot_app/common/pose2d.h"

namespace coppice::robot::localization {

class PoseHistory {
 public:
  /// Keeps `seconds` of it.
  explicit PoseHistory(double seconds = 2) : seconds_(seconds) {}

  /// base_link in the odometry frame at `stamp`. What is not newer than the newest is not used, but
  /// a stamp more than a second back starts the history anew: time itself was set back. A pose that
  /// no robot can have reached since the one before starts it anew, too: the odometry was
  /// restarted and its frame is another one. Not finite: not used.
  void Add(double stamp, const Pose2D& pose);

  /// Interpolated; nothing if the history does not cover that time.
  std::optional<Pose2D> At(double stamp) const;
  bool empty() const { return poses_.empty(); }
  double newest() const { return poses_.back().stamp; }
  /// Counts the times that the history was started anew: poses before and after do not compare.
  int frame() const { return frame_; }

 private:
  struct Stamped {
    double stamp = 0;
    Pose2D pose;
  };
  double seconds_;
  std::deque<Stamped> poses_;
  int frame_ = 0;
};

}  // namespace coppice::robot::localization

#endif  // COPPICE_ROBOT_APP_LOCALIZATION_POSE_HISTORY_H_
