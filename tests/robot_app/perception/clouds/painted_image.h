// Clouds painted by hand: what a lidar sees of simple things around it.
#ifndef COPPICE_TESTS_ROBOT_APP_PERCEPTION_CLOUDS_PAINTED_IMAGE_H_
#define COPPICE_TESTS_ROBOT_APP_PERCEPTION_CLOUDS_PAINTED_IMAGE_H_

#include <cmath>
#include <random>
#include <vector>

#include "robot_app/perception/clouds/range_image.h"

namespace coppice::robot::perception {

/// The points of a flat floor and of round pillars that stand on it, in the sensor's frame.
class PaintedCloud {
 public:
  /// In the sensor's axes, from its foot.
  struct Pillar {
    double x, y, radius, top;
    double bottom = 0;
  };

  /// `noise` is the standard deviation of a range [m].
  explicit PaintedCloud(std::vector<Pillar> pillars, double noise = 0) : noise_(noise) {
    for (int column = 0; column < geometry_.columns; ++column) {
      for (int ring = 0; ring < geometry_.rings; ++ring) Cast(column, ring, pillars);
    }
  }

  const std::vector<LidarPoint>& points() const { return points_; }
  RangeImage image() const {
    RangeImage image;
    FillRangeImage(points_, geometry_, image);
    return image;
  }

 private:
  void Cast(int column, int ring, const std::vector<Pillar>& pillars) {
    const double turn = M_PI - column * 2 * M_PI / geometry_.columns;
    const double slope = std::tan((ring - (geometry_.rings - 1) / 2.0) * geometry_.ring_step);
    double nearest = slope < 0 ? geometry_.height / -slope : INFINITY;
    for (const Pillar& pillar : pillars) {
      const double along = pillar.x * std::cos(turn) + pillar.y * std::sin(turn);
      const double aside = pillar.y * std::cos(turn) - pillar.x * std::sin(turn);
      if (along <= 0 || std::abs(aside) >= pillar.radius) continue;
      const double range = along - std::sqrt(pillar.radius * pillar.radius - aside * aside);
      const double height = geometry_.height + range * slope;
      if (height >= pillar.bottom && height <= pillar.top) nearest = std::min(nearest, range);
    }
    if (!(nearest < 100)) return;
    nearest += noise_ * normal_(random_);
    points_.push_back({static_cast<float>(nearest * std::cos(turn)),
                       static_cast<float>(nearest * std::sin(turn)),
                       static_cast<float>(nearest * slope), 50, static_cast<std::uint16_t>(ring)});
  }

  LidarGeometry geometry_;
  double noise_;
  std::mt19937 random_{1};
  std::normal_distribution<double> normal_;
  std::vector<LidarPoint> points_;
};

}  // namespace coppice::robot::perception

#endif  // COPPICE_TESTS_ROBOT_APP_PERCEPTION_CLOUDS_PAINTED_IMAGE_H_
