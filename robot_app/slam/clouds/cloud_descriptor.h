// A turn of the 3-D lidar in some numbers that stay the same however the robot is turned, so that
// two turns can be compared without laying one upon the other.
//
// K. Granstrom, T. B. Schon, J. I. Nieto, F. T. Ramos: Learning to close loops from range data,
// IJRR 30 (2011): global features of clouds and of pairs of clouds for a boosted classifier. Some
// of theirs are here, and what is seen of the walls around as a signal (the contour), of which the
// spectrum does not know of turns, as in G. Kim, A. Kim: Scan Context, IROS 2018.
//
// Points are in base_link, z up from the floor [m]. Pure functions; any thread.
#ifndef COPPICE_ROBOT_APP_SLAM_CLOUDS_CLOUD_DESCRIPTOR_H_
#define COPPICE_ROBOT_APP_SLAM_CLOUDS_CLOUD_DESCRIPTOR_H_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace coppice::robot::slam {

using CloudPoints = std::vector<Eigen::Vector3f>;

inline constexpr std::size_t kSectors = 120;  // of the contour, 3 degrees each
inline constexpr std::size_t kScalars = 31;   // features of a cloud
inline constexpr std::size_t kBins = 24;      // of a histogram
inline constexpr std::size_t kHistograms = 4;
inline constexpr std::size_t kPairFeatures = kScalars + kHistograms + 1;

struct CloudDescriptor {
  /// How far the farthest upright thing is that is seen in each sector, from -180 degrees counter-
  /// clockwise [m]; 0: nothing.
  std::array<float, kSectors> contour{};
  std::array<float, kScalars> scalars{};
  std::array<std::array<float, kBins>, kHistograms> histograms{};  ///< each sums up to 1
};

using PairFeatures = std::array<float, kPairFeatures>;

CloudDescriptor Describe(const CloudPoints& points);

/// What differs between two clouds; the same if they are swapped.
PairFeatures Compare(const CloudDescriptor& a, const CloudDescriptor& b);

/// How `b` may be turned against `a`: the yaw of b's base_link as seen from a's [rad], the
/// likeliest first, at most `most`, none within 15 degrees of another.
std::vector<double> LikelyTurns(const CloudDescriptor& a, const CloudDescriptor& b,
                                std::size_t most);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_CLOUDS_CLOUD_DESCRIPTOR_H_
