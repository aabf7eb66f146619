// The simulated robot on its floor: everything that moves, and everything that the robot measures.
//
// A World is a deterministic machine: the same floor, options and sequence of calls give the same
// trace, bit by bit. It knows no ROS, no clock and no thread; whoever owns it calls Step() and
// reads. Frames (REP-105): `map` of the floor, `odom` where the robot stood at the start,
// `base_link` between the wheels, `laser` at the front lidar. Not thread-safe.
#ifndef COPPICE_ROBOT_APP_SIMULATION_WORLD_H_
#define COPPICE_ROBOT_APP_SIMULATION_WORLD_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/simulation/battery.h"
#include "robot_app/simulation/bodies.h"
#include "robot_app/simulation/drive.h"
#include "robot_app/simulation/floor.h"
#include "robot_app/simulation/floor_scene.h"
#include "robot_app/simulation/lidar.h"
#include "robot_app/simulation/lidar_3d.h"
#include "robot_app/simulation/odometry.h"
#include "robot_app/simulation/people.h"
#include "robot_app/simulation/sonar/sonar.h"

namespace coppice::robot::simulation {

struct WorldOptions {
  std::uint64_t seed = 1;        ///< of all noise
  std::optional<Pose2> start;    ///< of base_link in the map frame; absent: docked
  double state_of_charge = 1;    ///< of the battery, 0..1
  double radius = kRobotRadius;  ///< of the robot on the floor, m
  LidarOptions lidar;
  Lidar3dOptions lidar_3d;
  SonarsOptions sonars = ShippedSonars();
  DriveOptions drive;
  BatteryOptions battery;
  OdometryOptions odometry;
};

/// What the sonars have heard, all at the same time.
struct Echoes {
  double time = -1;                            ///< simulated, s; negative: never yet
  std::array<float, kSonars.size()> ranges{};  ///< as Sonar::Measure, in the order of kSonars
};

/// What came of a request, in one sentence for a person; or why it is refused.
using Change = Expected<std::string>;

class World {
 public:
  explicit World(const Floor& floor, const WorldOptions& options = {});

  /// Lets `dt` seconds pass (greater than 0; 0.01 to 0.05 is sensible). `command` is a velocity
  /// command that arrives at the start of the step; without a new one the last one counts until it
  /// times out.
  void Step(double dt, const std::optional<Velocity>& command = std::nullopt);

  // --- the truth ---
  double time() const { return time_; }            ///< s since the start
  Pose2 robot() const { return bodies_.robot(); }  ///< base_link in the map frame
  Velocity velocity() const { return bodies_.velocity(); }
  bool touching() const { return bodies_.touching(); }           ///< the robot touches something
  bool docked() const;                                           ///< the charging contacts touch
  const Pose2& station_moved() const { return station_moved_; }  ///< by MoveStation()
  /// Where the landmark stands now, if there is one.
  std::optional<Triangle> landmark() const;
  /// base_link when docked according to the landmark.
  Pose2 station() const { return Compose(floor_.docked, station_moved_); }
  bool charger_on() const { return charger_on_; }
  bool emergency_stop() const { return emergency_stop_; }
  bool protective_stop() const { return drive_.protective_stop(); }
  const std::vector<Disc>& people() const { return people_.discs(); }
  /// How everybody stands or walks, in the floor's order.
  std::vector<Stance> stances() const { return people_.Stances(); }
  const Floor& floor() const { return floor_; }
  const std::vector<bool>& door_open() const { return door_open_; }  ///< in the floor's order
  const std::vector<bool>& place_blocked() const {
    return place_blocked_;
  }  ///< in the floor's order
  /// What stands still now: walls, furniture, the boxes of blocked places, door leaves, the
  /// landmark.
  const StillScene& still() const { return scene_.still(); }

  // --- the sensors; each reading carries its time ---
  const Scan& scan() const { return lidar_.scan(); }
  const Lidar& lidar() const { return lidar_; }
  const Lidar3d& lidar_3d() const { return lidar_3d_; }
  /// It costs much more than all else, so it turns only while this is on; off at first.
  void SetLidar3dOn(bool on);
  const Echoes& echoes() const { return echoes_; }
  const std::vector<Sonar>& sonars() const { return sonars_; }  ///< in the order of kSonars
  /// They cost as much as the laser; off at first.
  void SetSonarsOn(bool on) { sonars_on_ = on; }
  const Odometry& odometry() const { return odometry_; }
  const ImuReading& imu() const { return imu_.reading(); }  ///< of the last step
  const Battery& battery() const { return battery_; }
  /// The true pose of `odom` in `map` now: what a perfect localization would deliver.
  Pose2 OdomInMap() const;

  // --- changes from outside; refused with a reason, and then nothing has changed ---
  Change SetPlaceBlocked(const std::string& place, bool blocked);
  Change SetDoorOpen(const std::string& door, bool open);
  Change SetStateOfCharge(double state_of_charge);
  /// Lifts the robot and puts it down elsewhere. Its wheels do not turn, so odometry does not
  /// notice.
  Change Kidnap(const Pose2& pose);
  /// Moves the charging station with its landmark to where it stands `moved` away from its place on
  /// the floor, as seen by a robot that is docked there (x into the station): at most 1 m and 45
  /// degrees. What the robot knows of its station stays where it was. {}: back in place.
  Change MoveStation(const Pose2& moved);
  /// Bends the charging contacts sideways, away from where the landmark promises them, seen from a
  /// docked robot positive to its left [m]. 0: straight.
  Change SetContactsOffset(double offset);
  /// Takes the station's landmark away, or puts it back.
  Change SetLandmark(bool there);
  /// A charger that is off gives no current, though the contacts touch.
  Change SetChargerOn(bool on);
  /// Has one of the people walk behind the robot, or back and on with the own round.
  Change SetFollows(const std::string& person, bool follows);
  /// Pressed, it takes the motors away; the computers run on.
  Change SetEmergencyStop(bool pressed);

 private:
  void MovePeople(double dt);
  void ShowPeople();
  void MoveRobot(double dt);
  void ReadSensors();
  void ReadSonars();
  void Rebuild();
  std::string WhatIsNear(const Triangle& landmark, Vec2 docked) const;
  bool CanStandAt(Vec2 point) const;
  template <typename DistanceTo>
  std::string WhoStandsNear(DistanceTo distance) const;
  Disc robot_disc() const { return {robot().position(), radius_}; }

  Floor floor_;
  Ground ground_;
  double radius_;  // of the robot
  double time_ = 0;
  std::vector<bool> door_open_;
  std::vector<bool> place_blocked_;
  Bodies bodies_;
  People people_;
  Drive drive_;
  Battery battery_;
  Pose2 station_moved_;
  double contacts_offset_ = 0;
  bool landmark_there_ = true;
  bool charger_on_ = true;
  bool emergency_stop_ = false;
  Lidar lidar_;
  Lidar3d lidar_3d_;
  bool lidar_3d_on_ = false;
  std::vector<Sonar> sonars_;
  bool sonars_on_ = false;
  Echoes echoes_;
  Odometry odometry_;
  Imu imu_;
  std::vector<Figure> figures_;  // the people
  std::vector<Disc> legs_;       // what the laser sees of them
  Scene scene_;                  // what stands still and, while the 3-D lidar turns, the people
  Scene audible_;                // the same with the glass, for the sonars
  RayCaster visible_;            // of what stands still: what is as high as the lidar and no glass
  RayCaster solid_;              // and all of it, for people's feet
  double next_scan_ = 0;
  double next_odometry_ = 0;
  double next_echoes_ = 0;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_WORLD_H_
