// A simulated RGB-D camera that stands level, as an Intel D435: a picture in colour and the depth
// of each of its pixels, of the same instant. Drawn without a graphics card, column by column:
// whatever stands upright on the floor fills one stretch of a column; people are pictures of people
// that face the lens. The same scene, people and seed give the same pictures, bit for bit.
//
//   RgbdCamera camera(options, seed);
//   const RgbdPicture seen = camera.Take(scene, people, Compose(robot, mount), kLensHeight);
//
// Source of the figures: Intel RealSense D400 Series data sheet (range, depth accuracy); lens and
// size of the pictures as in the published software of the robot.
#ifndef COPPICE_ROBOT_APP_SIMULATION_CAMERA_RGBD_CAMERA_H_
#define COPPICE_ROBOT_APP_SIMULATION_CAMERA_RGBD_CAMERA_H_

#include <cstdint>
#include <vector>

#include "robot_app/common/picture.h"
#include "robot_app/simulation/appearance/person_picture.h"
#include "robot_app/simulation/camera/camera_fault.h"
#include "robot_app/simulation/scene/scene.h"

namespace coppice::robot::simulation {

struct RgbdOptions {
  int width = 640;
  int height = 480;
  Lens lens{615.18, 615.18, 326.22, 236.27};
  double min_depth = 0.28;      ///< m
  double max_depth = 10;        ///< m
  double max_depth_in_sun = 2;  ///< m; farther its infrared is lost in that of the sun
  double sun_from = 0.3;        ///< light from which on it is the sun's, under the sky
  double depth_noise = 0.0026;  ///< standard deviation at 1 m; grows with the square [m]
  int colour_noise = 3;         ///< most, of 255, at full light; in the dark it is amplified
  double most_gain = 8;         ///< darker than that is balanced no more
};

struct RgbdPicture {
  Picture colour;
  DepthPicture depth;  ///< as the colour lens sees it
};

/// Somebody to be seen.
struct SeenPerson {
  Stance stance;
  PersonLook look;
};

class RgbdCamera {
 public:
  RgbdCamera(const RgbdOptions& options, std::uint64_t seed);

  const RgbdOptions& options() const { return options_; }

  /// `pose` is that of the lens on the floor, which looks along its yaw; `height` is above the
  /// floor [m].
  RgbdPicture Take(const Scene& scene, const std::vector<SeenPerson>& people, const Pose2& pose,
                   double height, const CameraFault& fault = {});

 private:
  RgbdOptions options_;
  std::uint64_t seed_;
  std::uint64_t taken_ = 0;  // pictures
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_CAMERA_RGBD_CAMERA_H_
