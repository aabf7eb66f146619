// Which configuration suits the place where the robot is: how far the walls are and how bright it
// is decide, with hysteresis, so that a doorway does not make it flutter.
//
// | configuration | walls                        | range of the map | depth of the cameras |
// |---|---|---|---|
// | indoor        | near                         | short            | is entered, too      |
// | hall          | far                          | longer           | is left out          |
// | outdoor       | hardly any, and it is bright | long             | is left out          |
//
// In the dark the cameras are not asked for places. S. Ehlers, M. Stuede, K. Nuelle, T. Ortmaier:
// Map Management Approach for SLAM in Large-Scale Indoor and Outdoor Areas, ICRA 2020.
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_ENVIRONMENT_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_ENVIRONMENT_H_

#include <array>
#include <optional>
#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/slam/clouds/cloud_descriptor.h"

namespace coppice::robot::slam {

enum class Surroundings { kIndoor, kHall, kOutdoor };

/// "indoor", "hall", "outdoor".
const char* NameOf(Surroundings surroundings);

/// What a person asks for by these names; nothing for "auto". Another word is a problem.
Expected<std::optional<Surroundings>> AskedSurroundings(const std::string& text);

/// What a configuration changes.
struct SlamConfiguration {
  Surroundings surroundings = Surroundings::kIndoor;
  double range = 8;         ///< of what is entered into the map [m]
  bool has_cameras = true;  ///< their depth is entered, too, not only the lidar's
};
SlamConfiguration ConfigurationFor(Surroundings surroundings);

struct EnvironmentSettings {
  double hall = 5.5;    ///< walls that are farther than this make a hall [m],
  double indoor = 4.5;  ///< nearer than this again none
  double open = 0.5;    ///< share of the directions without a wall: outdoors,
  double closed = 0.3;  ///< less than this again not
  double patience = 3;  ///< so long it must be so before it is believed [s]
  double dark = 0.05;   ///< brightness of a picture in which nothing is recognized, 0..1
};

/// What is judged by.
struct EnvironmentReading {
  double walls = 0;       ///< median of the distances to walls [m]
  double open = 0;        ///< share of the directions in which there is none, 0..1
  double brightness = 1;  ///< of the pictures, 0..1
};
EnvironmentReading Read(const CloudDescriptor& cloud, double brightness);

class Environment {
 public:
  explicit Environment(EnvironmentSettings settings = {}) : settings_(settings) {}

  /// `stamp` in seconds, ascending but where time is set back; of the first reading nothing is
  /// waited for.
  void Add(double stamp, const EnvironmentReading& reading);

  /// A person says what it is; nothing: it is judged again.
  void Force(std::optional<Surroundings> surroundings) { forced_ = surroundings; }

  Surroundings surroundings() const {
    return forced_.value_or(judged_.value_or(Surroundings::kIndoor));
  }
  bool is_forced() const { return forced_.has_value(); }
  bool is_dark() const { return reading_.brightness < settings_.dark; }
  const EnvironmentReading& reading() const { return reading_; }

 private:
  Surroundings Judge(const EnvironmentReading& reading) const;

  EnvironmentSettings settings_;
  EnvironmentReading reading_;
  std::optional<Surroundings> judged_;
  std::optional<Surroundings> forced_;
  Surroundings other_ = Surroundings::kIndoor;  // that it may have become
  double since_ = 0;                            // when it began to look so
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_ENVIRONMENT_H_
