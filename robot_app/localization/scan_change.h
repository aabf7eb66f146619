// How much of what the scanner sees is suddenly another: a robot that is carried away, while
// neither its wheels nor its gyroscope notice, sees other things from one scan to the next. People
// walk, and doors turn, too slowly for that.
#ifndef COPPICE_ROBOT_APP_LOCALIZATION_SCAN_CHANGE_H_
#define COPPICE_ROBOT_APP_LOCALIZATION_SCAN_CHANGE_H_

#include "robot_app/common/laser_scan.h"

namespace coppice::robot::localization {

class ScanChange {
 public:
  /// The scan before is forgotten, because the odometry has another frame.
  void Clear() { before_.ranges.clear(); }

  /// The share of the beams, 0..1, that end at least 0.2 m and a tenth of the range nearer or
  /// farther than what the scan before saw within a degree of that direction. What moves with the
  /// robot's turn since then does not count. 0 for the first scan, and if the scan before is older
  /// than 0.25 s, more than 0.15 m away or of another scanner. `odometry` is base_link when the
  /// scan was taken.
  double Add(const LaserScan& scan, const Pose2D& odometry);

 private:
  LaserScan before_;
  Pose2D odometry_;  // when it was taken
};

}  // namespace coppice::robot::localization

#endif  // COPPICE_ROBOT_APP_LOCALIZATION_SCAN_CHANGE_H_
