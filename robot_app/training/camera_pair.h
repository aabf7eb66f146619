// The robot's RGB-D cameras as they look at a simulated crowd, one after the other, and who is seen
// in their pictures.
#ifndef COPPICE_ROBOT_APP_TRAINING_CAMERA_PAIR_H_
#define COPPICE_ROBOT_APP_TRAINING_CAMERA_PAIR_H_

#include <optional>
#include <vector>

#include "robot_app/common/robot_description.h"
#include "robot_app/perception/camera/people_in_pictures.h"
#include "robot_app/simulation/camera/rgbd_camera.h"

namespace coppice::robot::training {

/// What came of one picture.
struct Glance {
  double time = 0;         ///< of the picture [s]
  simulation::Pose2 lens;  ///< on the floor, in the frame of the scene
  double half_angle = 0;   ///< to either side of where it looks it sees people [rad]
  std::vector<perception::Detection> people;
};

/// Between two pictures of a camera that are looked at [s].
struct CameraPeriods {
  double depth = 0.5;
  double colour = 0.5;  ///< and no oftener than the depth
};

class CameraPair {
 public:
  /// A camera at each of `mounts` (in base_link), with who looks at its pictures, the cameras in
  /// turn.
  CameraPair(const std::vector<Mount>& mounts, std::vector<perception::PeopleInPictures> people,
             const CameraPeriods& periods, std::uint64_t seed);

  /// If it is time for a picture: who is in it.
  std::optional<Glance> Look(double time, const simulation::Scene& scene,
                             const std::vector<simulation::SeenPerson>& crowd,
                             const simulation::Pose2& robot);

  const CameraPeriods& periods() const { return periods_; }

 private:
  struct Camera {
    Mount mount;
    simulation::RgbdCamera lens;
    perception::PeopleInPictures people;
    double due = 0;
    double colour_due = 0;
  };
  Glance Take(Camera& camera, double time, const simulation::Scene& scene,
              const std::vector<simulation::SeenPerson>& crowd, const simulation::Pose2& robot);

  std::vector<Camera> cameras_;
  CameraPeriods periods_;
};

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_CAMERA_PAIR_H_
