// An ultrasonic sensor: it hears the nearest thing in its cone and not where in the cone it is. Of
// the paper's robot: three Bosch Parkpilot URF7 at its front. Glass and what is too low for the
// laser echo as everything else does; a surface that the sound meets at a slant sends it elsewhere
// and is not heard, as is the floor.
// Source: J. J. Leonard, H. F. Durrant-Whyte: Directed Sonar Sensing for Mobile Robot Navigation,
// Kluwer 1992 (specular echoes).
#ifndef COPPICE_ROBOT_APP_SIMULATION_SONAR_SONAR_H_
#define COPPICE_ROBOT_APP_SIMULATION_SONAR_SONAR_H_

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "robot_app/simulation/scene/scene.h"

namespace coppice::robot::simulation {

struct SonarOptions {
  double field_of_view = kPi / 6;  ///< of the whole cone [rad]
  double min_range = 0.2;          ///< m
  double max_range = 4;            ///< m
  double noise = 0.02;             ///< standard deviation of a range, m
  double steepest_echo = kPi / 4;  ///< between sound and the normal of what echoes [rad]
  Pose2 mounting{0.33, 0, 0};      ///< in base_link
  double height = 0.2;             ///< above the floor, m
};

/// /sonar/NAME, mounted on the frame sonar_NAME.
inline constexpr std::array<const char*, 3> kSonars = {"left", "front", "right"};

/// Those of the shipped robot, in the order of kSonars.
using SonarsOptions = std::array<SonarOptions, kSonars.size()>;
SonarsOptions ShippedSonars();

class Sonar {
 public:
  Sonar(const SonarOptions& options, std::uint64_t seed);

  /// Measures from the robot's pose `base` in the map frame: metres to the nearest echo; infinity
  /// if there is none within the range, minus infinity if it is too near to measure (REP-117).
  /// Allocates nothing after the first time.
  float Measure(const Pose2& base, const Scene& scene);

  const SonarOptions& options() const { return options_; }

 private:
  // The rays of the cone that have one direction on the floor.
  struct Fan {
    double angle = 0;
    std::vector<double> slopes;
  };
  double NearestEcho(const Fan& fan, const Pose2& sensor, const Scene& scene);

  SonarOptions options_;
  std::mt19937_64 random_;
  std::normal_distribution<double> noise_;
  std::vector<Fan> fans_;
  std::vector<Hit> hits_;  // of a fan
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_SONAR_SONAR_H_
