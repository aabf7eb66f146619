// Which corners of two pictures are the same, by their descriptions alone.
#ifndef COPPICE_ROBOT_APP_SLAM_PICTURES_CORNER_PAIRS_H_
#define COPPICE_ROBOT_APP_SLAM_PICTURES_CORNER_PAIRS_H_

#include <cstddef>
#include <vector>

#include "robot_app/slam/pictures/features.h"

namespace coppice::robot::slam {

struct CornerPair {
  std::size_t old_corner = 0;
  std::size_t new_corner = 0;
};

/// Each is the best for the other, and the second best is clearly worse; with depth in the old
/// picture. In the order of the old corners. 1 ms for 500 corners each.
std::vector<CornerPair> PairsOf(const PictureFeatures& old_picture,
                                const PictureFeatures& new_picture);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_PICTURES_CORNER_PAIRS_H_
