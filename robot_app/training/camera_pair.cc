#include "robot_app/training/camera_pair.h"

#include <utility>

#include "robot_app/perception/sightings/depth_turn.h"

namespace coppice::robot::training {
namespace {

using perception::Ranges;
using simulation::Pose2;

// The optical frame: z where the lens looks, x to its right, y down.
Eigen::Isometry3d OpticalFrame(const Pose2& lens, double height) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d forward(std::cos(lens.yaw), std::sin(lens.yaw), 0);
  frame.linear().col(0) = Eigen::Vector3d(forward.y(), -forward.x(), 0);
  frame.linear().col(1) = -Eigen::Vector3d::UnitZ();
  frame.linear().col(2) = forward;
  frame.translation() = Eigen::Vector3d(lens.x, lens.y, height);
  return frame;
}

}  // namespace

CameraPair::CameraPair(const std::vector<Mount>& mounts,
                       std::vector<perception::PeopleInPictures> people,
                       const CameraPeriods& periods, std::uint64_t seed)
    : periods_(periods) {
  for (std::size_t i = 0; i < mounts.size(); ++i) {
    const double turn = periods.depth * static_cast<double>(i) / static_cast<double>(mounts.size());
    cameras_.push_back(
        {mounts[i], simulation::RgbdCamera({}, 2 * seed + i), std::move(people[i]), turn, turn});
  }
}

std::optional<Glance> CameraPair::Look(double time, const simulation::Scene& scene,
                                       const std::vector<simulation::SeenPerson>& crowd,
                                       const Pose2& robot) {
  for (Camera& camera : cameras_) {
    if (time + 1e-9 < camera.due) continue;
    camera.due += periods_.depth;
    return Take(camera, time, scene, crowd, robot);
  }
  return std::nullopt;
}

Glance CameraPair::Take(Camera& camera, double time, const simulation::Scene& scene,
                        const std::vector<simulation::SeenPerson>& crowd, const Pose2& robot) {
  const Pose2D& at = camera.mount.pose;
  Glance glance;
  glance.time = time;
  glance.lens = Compose(robot, Pose2{at.x, at.y, at.yaw});
  const simulation::RgbdOptions& options = camera.lens.options();
  glance.half_angle = perception::HalfAngle(options.lens, options.width);
  simulation::RgbdPicture picture =
      camera.lens.Take(scene, crowd, glance.lens, camera.mount.height);
  Ranges ranges;
  ranges.lens = options.lens;
  ranges.depth = std::move(picture.depth);
  ranges.optical_in_frame = OpticalFrame(glance.lens, camera.mount.height);
  const bool in_colour = time + 1e-9 >= camera.colour_due;
  if (in_colour) camera.colour_due += periods_.colour;
  glance.people = perception::Join(in_colour ? camera.people.Find(picture.colour, ranges)
                                             : camera.people.FindInDepth(ranges));
  return glance;
}

}  // namespace coppice::robot::training
