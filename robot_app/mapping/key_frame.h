// The scans that make up a map, each with the place where it was taken.
#ifndef COPPICE_ROBOT_APP_MAPPING_KEY_FRAME_H_
#define COPPICE_ROBOT_APP_MAPPING_KEY_FRAME_H_

#include <cstddef>
#include <vector>

#include "robot_app/common/laser_scan.h"
#include "robot_app/localization/beams.h"

namespace coppice::robot::mapping {

/// The scans and the poses of base_link in the map frame at which they were taken; indices agree.
struct KeyFrames {
  std::vector<LaserScan> scans;
  std::vector<Pose2D> poses;
  std::size_t size() const { return poses.size(); }
};

struct MappingSettings {
  double resolution = 0.05;  ///< of the map [m]
  double range = 12;         ///< beams are believed up to here [m]
  double step = 0.4;         ///< a key frame after so much way [m]
  double turn = 0.35;        ///< or after such a turn [rad]
  double drift = 0.05;       ///< how much odometry and matching may go wrong, share of the way
  double agree = 0.5;        ///< below this score a scan does not fit what was seen before
  double loop_agree = 0.7;   ///< share of the beams that must agree to close a loop
  std::size_t window = 40;   ///< key frames that a new one is matched with
  std::size_t most_frames = 20000;
};

/// The beams of a scan up to `range` [m]; see BeamsOf.
std::vector<localization::Beam> BeamsWithin(const LaserScan& scan, double range, double spacing,
                                            int most);

/// What the key frames [first, end) have seen, as a map.
OccupancyGrid MapOf(const KeyFrames& frames, std::size_t first, std::size_t end,
                    const MappingSettings& settings);

}  // namespace coppice::robot::mapping

#endif  // COPPICE_ROBOT_APP_MAPPING_KEY_FRAME_H_
