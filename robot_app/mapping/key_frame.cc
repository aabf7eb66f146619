#include "robot_app/mapping/key_frame.h"

#include <algorithm>

#include "robot_app/mapping/log_odds_grid.h"

namespace coppice::robot::mapping {

std::vector<localization::Beam> BeamsWithin(const LaserScan& scan, double range, double spacing,
                                            int most) {
  LaserScan clipped = scan;
  clipped.range_max = std::min(scan.range_max, range);
  return localization::BeamsOf(clipped, spacing, most);
}

OccupancyGrid MapOf(const KeyFrames& frames, std::size_t first, std::size_t end,
                    const MappingSettings& settings) {
  LogOddsGrid grid(settings.resolution);
  for (std::size_t i = first; i < end; ++i) {
    grid.Add(frames.scans[i], frames.poses[i], settings.range);
  }
  return grid.ToMap();
}

}  // namespace coppice::robot::mapping
