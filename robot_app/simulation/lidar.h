// The 2-D laser scanner at the front of the robot.
#ifndef COPPICE_ROBOT_APP_SIMULATION_LIDAR_H_
#define COPPICE_ROBOT_APP_SIMULATION_LIDAR_H_

#include <cstdint>
#include <random>
#include <vector>

#include "robot_app/simulation/scene/ground.h"
#include "robot_app/simulation/scene/ray_caster.h"

namespace coppice::robot::simulation {

struct LidarOptions {
  int beams = 541;                   ///< at least 2
  double field_of_view = 1.5 * kPi;  ///< symmetrical about the front
  double min_range = 0.02;           ///< m
  double max_range = 20;             ///< m
  double noise = 0.01;               ///< standard deviation of a range, m
  double period = 0.1;               ///< s
  Pose2 mounting{0.25, 0, 0};        ///< of the frame `laser` in base_link
  double height = 0.3;               ///< above the floor, m; what ends below it is not seen
};

/// One turn. Beam i looks at angle_min + i * angle_step in the frame `laser`. A beam that meets
/// nothing has the range infinity (REP-117).
struct Scan {
  double time = 0;  ///< simulated, s
  double angle_min = 0;
  double angle_step = 0;
  std::vector<float> ranges;
};

class Lidar {
 public:
  Lidar(const LidarOptions& options, std::uint64_t seed);

  /// Measures from the robot's pose `base` in the map frame and keeps the result. Allocates nothing
  /// after the first time.
  void Measure(double time, const Pose2& base, const RayCaster& still,
               const std::vector<Disc>& moving, const Ground& ground = Ground());

  const Scan& scan() const { return scan_; }
  const LidarOptions& options() const { return options_; }

 private:
  LidarOptions options_;
  std::mt19937_64 random_;
  std::normal_distribution<double> noise_;
  Scan scan_;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_LIDAR_H_
