// One turn of a 3-D lidar as a picture: a row for each ring, a column for each direction, in each
// cell the point that was met there. Neighbours in the picture are neighbours for the sensor, so
// what belongs together is found without a search in space.
//
// Frames (REP-105): points come in the sensor's frame (`velodyne`: x forward, z up) and lie in the
// picture in a frame of the same axes on the floor below the sensor, so that z is the height above
// the floor. Metres and radians.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_RANGE_IMAGE_H_
#define COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_RANGE_IMAGE_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace coppice::robot::perception {

/// What a lidar says of one direction, in its own frame. NaN in x, y or z: it met nothing.
struct LidarPoint {
  float x = 0, y = 0, z = 0;
  float intensity = 0;     ///< 0..255
  std::uint16_t ring = 0;  ///< from the lowest
  float time = 0;          ///< since the stamp of the cloud [s]
};

/// How the sensor looks around and where it is; as a Velodyne Puck on the robot.
struct LidarGeometry {
  int rings = 16;             ///< 1 to 64
  int columns = 900;          ///< of the picture; a turn of the sensor may have a few more or less
  float ring_step = 0.0349F;  ///< angle between two rings [rad]
  float height = 1.2F;        ///< above the floor [m]
  float min_range = 0.4F;     ///< nearer is the robot itself [m]

  float column_step() const { return 2 * 3.14159265F / static_cast<float>(columns); }
};

/// The column in which a direction on the floor lies; columns go clockwise from behind, as the
/// sensor turns.
int ColumnOf(const Eigen::Vector2f& direction, const LidarGeometry& geometry);

struct RangeImage {
  LidarGeometry geometry;
  // All of one length, a column after the other, each from the lowest ring up.
  std::vector<Eigen::Vector3f> points;  ///< z above the floor
  std::vector<float> ranges;            ///< from the sensor; 0: nothing there
  std::vector<float> intensities;

  std::size_t size() const { return ranges.size(); }
  int ring(std::size_t cell) const { return static_cast<int>(cell) % geometry.rings; }
  int column(std::size_t cell) const { return static_cast<int>(cell) / geometry.rings; }
  /// Columns go round: -1 is the last one; up to one turn too far.
  std::size_t cell(int ring, int column) const {
    const int c = column < 0                   ? column + geometry.columns
                  : column >= geometry.columns ? column - geometry.columns
                                               : column;
    return static_cast<std::size_t>(c) * geometry.rings + ring;
  }
};

/// Sorts the points into `image`, which may be one of before: then nothing is allocated. Where two
/// fall into one cell the nearer one stays. Points of rings that the sensor does not have, without
/// finite numbers or nearer than the sensor can see are left out; returns how many were kept.
std::size_t FillRangeImage(const std::vector<LidarPoint>& points, const LidarGeometry& geometry,
                           RangeImage& image);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_RANGE_IMAGE_H_
