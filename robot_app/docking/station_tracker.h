// Where the charging station is, from all scans so far: a Kalman filter over the sightings of its
// landmark, in the frame of the odometry. That frame drifts slowly and never jumps, whatever the
// localization thinks; what the drift may be is added with the way.
//
//   StationTracker tracker(settings);
//   tracker.AddScan(scan, base_in_odom, expected_docked_in_odom);
//   if (tracker.seen()) ...   // tracker.seen()->docked
//
// A deterministic state machine without a clock, a thread or ROS.
#ifndef COPPICE_ROBOT_APP_DOCKING_STATION_TRACKER_H_
#define COPPICE_ROBOT_APP_DOCKING_STATION_TRACKER_H_

#include <Eigen/Core>
#include <optional>

#include "robot_app/docking/landmark.h"

namespace coppice::robot::docking {

/// The station as it is seen.
struct StationSighting {
  Pose2D docked;             ///< base_link when docked, in the odometry frame
  double stamp = 0;          ///< of the last scan that showed the landmark [s]
  int scans = 0;             ///< that have shown it
  double deviation = 0;      ///< standard deviation of the place of its corner [m]
  double yaw_deviation = 0;  ///< rad
};

class StationTracker {
 public:
  explicit StationTracker(LandmarkSettings settings = {}) : settings_(settings) {}

  /// Forgets what it has seen.
  void Reset() {
    seen_.reset();
    scans_ = 0;
  }

  /// `base`: base_link in the odometry frame at the time of the scan. `expected`: where base_link
  /// is thought to be when docked, in the same frame, from a map; then a landmark that is elsewhere
  /// is not this station's.
  void AddScan(const LaserScan& scan, const Pose2D& base, const std::optional<Pose2D>& expected);

  /// Nothing before the landmark was seen in some scans, and when it has not been where it should
  /// be for a while.
  const std::optional<StationSighting>& seen() const { return seen_; }

 private:
  void Begin(const LaserScan& scan, const Pose2D& base, const std::optional<Pose2D>& expected);
  void Drift(const Pose2D& base);
  bool Correct(const LandmarkSighting& sighting, const Pose2D& base);
  void Tell(double stamp);

  LandmarkSettings settings_;
  Pose2D base_;                 // at the last scan
  Pose2D corner_;               // of the landmark, in the odometry frame
  Eigen::Matrix3d covariance_;  // of corner_
  int scans_ = 0;               // that have shown it; 0: it is not known
  int misses_ = 0;              // scans in a row in which it was elsewhere
  std::optional<StationSighting> seen_;
};

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_STATION_TRACKER_H_
