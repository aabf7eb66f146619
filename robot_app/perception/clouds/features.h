// What a cluster looks like, in numbers that a classifier can learn from.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_FEATURES_H_
#define COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_FEATURES_H_

#include <array>

#include "robot_app/perception/clouds/clusters.h"

namespace coppice::robot::perception {

inline constexpr int kSlices = 10;                  ///< of 0.2 m from the floor up
inline constexpr int kFeatures = 18 + 3 * kSlices;  ///< their order is that of Describe()

inline constexpr int kHiddenSides = 14;  ///< where Features tells how much is hidden, 0..1

using Features = std::array<float, kFeatures>;

/// Describes the cluster with these cells (at least three) as the sensor sees it: extents along and
/// across the view, how its points lie in slices of height, how round and how even its front is,
/// how bright, and whether its sides are its own or the edge of something before it. Extents and
/// shapes after Navarro-Serment et al., "Pedestrian Detection and Tracking Using Three-dimensional
/// LADAR Data", IJRR 2010, and Kidono et al., IV 2011.
Features Describe(const RangeImage& image, Clusters::Cells cells);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_FEATURES_H_
