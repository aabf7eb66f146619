// The 3-D laser scanner on top of the robot, as a Velodyne Puck (VLP-16): sixteen rings that turn
// ten times a second. It measures while it turns, so a cloud of a robot that drives is bent as a
// real one: each point is where the sensor saw it from at its own time.
// Source: VLP-16 user manual, Velodyne Lidar 63-9243 (range, angles, noise).
#ifndef COPPICE_ROBOT_APP_SIMULATION_LIDAR_3D_H_
#define COPPICE_ROBOT_APP_SIMULATION_LIDAR_3D_H_

#include <cstdint>
#include <random>
#include <vector>

#include "robot_app/simulation/scene/scene.h"

namespace coppice::robot::simulation {

struct Lidar3dOptions {
  int rings = 16;                   ///< at least 2
  int columns = 900;                ///< a turn
  double lowest = -15 * kPi / 180;  ///< the lowest ring above the horizon [rad]; the highest: its
                                    ///< opposite
  double min_range = 0.4;           ///< m
  double max_range = 100;           ///< m
  double noise = 0.03;              ///< standard deviation of a range, m
  double period = 0.1;              ///< of a turn, s
  Pose2 mounting{0, 0, 0};          ///< of the frame `velodyne` in base_link
  double height = 1.2;              ///< of it above the floor, m
};

/// Tangents of the rings' angles above the horizon, from the lowest up.
std::vector<double> RingSlopes(const Lidar3dOptions& options);

/// One ray's end in the frame `velodyne`; NaN in x, y and z if it met nothing.
struct CloudPoint {
  float x = 0, y = 0, z = 0;
  float intensity = 0;     ///< 0..255
  std::uint16_t ring = 0;  ///< from the lowest
  float time = 0;          ///< since the begin of the turn, s
};

/// A turn, column after column clockwise from behind, each from the lowest ring up.
struct Cloud {
  double time = 0;  ///< of its begin; simulated, s
  std::vector<CloudPoint> points;
};

class Lidar3d {
 public:
  Lidar3d(const Lidar3dOptions& options, std::uint64_t seed);

  /// Measures the columns that pass from `time` on in `dt` seconds, all from the robot's pose
  /// `base` in the map frame. Allocates nothing after the first turns.
  void Turn(double time, double dt, const Pose2& base, const Scene& scene);

  /// Begins a turn now; what was measured of this one is forgotten.
  void Restart();

  /// The last whole turn; empty before the first one is whole.
  const Cloud& cloud() const { return cloud_; }
  const Lidar3dOptions& options() const { return options_; }

 private:
  void MeasureColumn(int column, const Pose2& base, const Scene& scene);

  Lidar3dOptions options_;
  std::mt19937_64 random_;
  std::normal_distribution<double> noise_;
  std::vector<double> slopes_;  // of the rings
  double turned_ = 0;           // columns of the turn that have passed
  Cloud next_;                  // the turn that is measured
  Cloud cloud_;
  std::vector<Hit> hits_;  // of a column
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_LIDAR_3D_H_
