// How far the surface of a person is from a lens, pixel by pixel: a picture of a person is flat, a
// body is not, and what looks for people in depth pictures knows them by that.
#ifndef COPPICE_ROBOT_APP_SIMULATION_CAMERA_PERSON_RELIEF_H_
#define COPPICE_ROBOT_APP_SIMULATION_CAMERA_PERSON_RELIEF_H_

#include <array>
#include <cstddef>

#include "robot_app/common/picture.h"
#include "robot_app/simulation/scene/figure.h"

namespace coppice::robot::simulation {

/// The pillars of a figure as one column of a picture meets them after another.
class PersonRelief {
 public:
  /// `camera` is the lens on the floor, which looks along its yaw from `height` above it [m].
  PersonRelief(const Figure& figure, const Lens& lens, const Pose2& camera, double height);

  /// The next calls of At are about this column.
  void LookAlong(int column);

  /// Along the optical axis to the surface in that row [m]; where clothes or hair are seen beside
  /// the pillars, to the body's axis.
  double At(int row) const;

 private:
  struct Stretch {
    double first_row = 0, last_row = 0;
    double depth = 0;
  };

  const Lens lens_;
  const double height_;
  const double axis_;            // depth [m]
  std::array<Pillar, 6> parts_;  // x forward, y left of the lens
  std::array<Stretch, 6> stretches_;
  std::size_t met_ = 0;  // of the stretches
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_CAMERA_PERSON_RELIEF_H_
