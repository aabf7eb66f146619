// A map of several sessions as pictures: the plan from above, the way of each session in a colour
// of its own, closures by pictures and by clouds; and sections.
//
//   EncodeJpeg(DrawPlan(grid, map, 0));
#ifndef COPPICE_ROBOT_APP_SLAM_DRAWING_MAP_PICTURE_H_
#define COPPICE_ROBOT_APP_SLAM_DRAWING_MAP_PICTURE_H_

#include <string>
#include <vector>

#include "robot_app/common/occupancy_grid.h"
#include "robot_app/common/picture.h"
#include "robot_app/slam/map/slam_map.h"

namespace coppice::robot::slam {

/// The grid is that of the map of session `of_session`, whose sessions are drawn upon it. x to the
/// right, y up; at most `most_pixels` wide.
Picture DrawPlan(const OccupancyGrid& grid, const SlamMap& map, std::uint32_t of_session,
                 int most_pixels = 1400);

/// A section of the voxels (VoxelMap::Section) with lines for each metre of height and each fifth
/// one along it; `name` is written below. At most `most_pixels` wide.
Picture DrawSection(const OccupancyGrid& section, const std::string& name, int most_pixels = 1400);

/// A curve of a chart.
struct Curve {
  std::string name;
  std::vector<double> x, y;  ///< of one length
};

/// Curves over the same axes; y from 0 to 1, x on a logarithmic axis if `is_logarithmic`.
Picture DrawCurves(const std::vector<Curve>& curves, const std::string& x_axis,
                   const std::string& y_axis, bool is_logarithmic);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_DRAWING_MAP_PICTURE_H_
