// A round through a simulated floor as the mapper of places sees it: a robot that drives along a
// way, what its odometry filter says of that, and what its cameras and its 3-D lidar see at each of
// many stops. No collisions and no ROS: a round of 120 m takes its pictures' time and no more.
#ifndef COPPICE_ROBOT_APP_TRAINING_SLAM_TOUR_H_
#define COPPICE_ROBOT_APP_TRAINING_SLAM_TOUR_H_

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/robot_description.h"
#include "robot_app/simulation/camera/rgbd_camera.h"
#include "robot_app/simulation/floor.h"
#include "robot_app/simulation/lidar_3d.h"
#include "robot_app/slam/pictures/features.h"

namespace coppice::robot::training {

struct TourSettings {
  std::uint64_t seed = 1;  ///< of all noise, the people and the doors
  double light = 1;        ///< 1: all lamps on; 0.02: nearly dark
  int people = 8;          ///< who stand or walk somewhere, elsewhere at each stop
  double moved_doors = 0;  ///< share of the doors that stand otherwise than the floor says
  double aside = 0;        ///< how far it drives from the way at most [m]
  double step = 0.5;       ///< a stop after so much way [m]
  double turn = 0.35;      ///< or after such a turn [rad]
};

/// Where the robot was when it looked, in truth and as its odometry says.
struct Stop {
  simulation::Pose2 truth;     ///< base_link in the frame of the floor
  simulation::Pose2 odometry;  ///< base_link in the frame odom
  double way = 0;              ///< since the start [m]
};

/// The stops on a way of straight pieces, turned on the spot between them.
std::vector<Stop> Drive(const std::vector<simulation::Vec2>& way, const TourSettings& settings);

/// The shipped institute: from the station through the corridor, round the hall, back and into two
/// offices; about 130 m, ending where it began.
std::vector<simulation::Vec2> RoundOfTheInstitute();

/// The cameras of a robot, in the order of simulation::kCameras, and its lidar.
struct RobotSensors {
  std::array<slam::CameraMount, 2> cameras;
  std::array<simulation::Pose2, 2> lenses;  ///< in base_link
  double lens_height = 0;                   ///< [m]
  double lidar_height = 0;                  ///< [m]
};
Expected<RobotSensors> SensorsOf(const RobotDescription& robot);

/// What stands on a floor in one session, and the robot's eyes in it.
class TourEyes {
 public:
  TourEyes(const simulation::Floor& floor, const RobotSensors& sensors,
           const TourSettings& settings);

  /// Camera 0 looks forwards, 1 backwards. The same stop gives the same people, for both.
  simulation::RgbdPicture TakePicture(const Stop& stop, std::size_t camera);

  /// A turn of the lidar: points in base_link, people's among them.
  std::vector<Eigen::Vector3f> TakeCloud(const Stop& stop);

 private:
  void PlacePeople(const Stop& stop);

  RobotSensors sensors_;
  TourSettings settings_;
  simulation::Scene scene_;
  std::vector<simulation::RgbdCamera> cameras_;
  simulation::Lidar3d lidar_;
  std::vector<simulation::SeenPerson> people_;
  double placed_at_ = -1;  // way of the stop [m]
};

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_SLAM_TOUR_H_
