// The robot's body as its description (URDF, http://wiki.ros.org/urdf/XML) says it: where each
// frame sits on it and how large it is. The shipped one is robot_app/description/sobi.urdf; no
// other place has these numbers. Read by liburdfdom.
//
//   const Expected<RobotDescription> robot = RobotDescription::Load("sobi.urdf");
//   const Expected<Mount> laser = robot->MountOf("laser");
//   laser->height;  // [m] above base_link
#ifndef COPPICE_ROBOT_APP_COMMON_ROBOT_DESCRIPTION_H_
#define COPPICE_ROBOT_APP_COMMON_ROBOT_DESCRIPTION_H_

#include <array>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot {

/// A frame in the one that it is mounted on.
struct FrameOnRobot {
  std::string name;
  std::string parent;
  std::array<double, 3> position{};            ///< [m]
  std::array<double, 4> rotation{0, 0, 0, 1};  ///< x, y, z, w
  bool is_fixed = true;                        ///< else it is given as the joint stands at zero
};

/// What turns within limits and carries a frame.
struct JointOnRobot {
  std::string name;
  std::string frame;             ///< that it carries, one of frames()
  std::array<double, 3> axis{};  ///< in that frame, a unit vector
  double lower = 0, upper = 0;   ///< [rad]
  double velocity = 0;           ///< at most [rad/s]
};

/// Where something sits that stands level.
struct Mount {
  Pose2D pose;        ///< in the plane of base_link
  double height = 0;  ///< above it [m]
};

/// Immutable; any thread.
class RobotDescription {
 public:
  /// A problem names the file and what is wrong with it. Never throws.
  static Expected<RobotDescription> Load(const std::string& file);

  /// The whole file, as the parameter /robot_description has it.
  const std::string& text() const { return text_; }

  /// Every frame but base_link, parents before children.
  const std::vector<FrameOnRobot>& frames() const { return frames_; }

  /// The revolute joints that have limits.
  const std::vector<JointOnRobot>& joints() const { return joints_; }

  /// In base_link. A problem if there is no such frame (with the nearest name), if it moves, or if
  /// it does not stand level.
  Expected<Mount> MountOf(const std::string& frame) const;

  // Of the collision cylinder of base_link, what the robot is taken for on the floor.
  double radius() const { return radius_; }  ///< [m]
  double height() const { return height_; }  ///< [m]

  // Of left_wheel and right_wheel.
  double wheel_diameter() const { return wheel_diameter_; }  ///< [m]
  double track() const { return track_; }                    ///< between the wheels [m]

 private:
  std::string text_;
  std::vector<FrameOnRobot> frames_;
  std::vector<JointOnRobot> joints_;
  double radius_ = 0;
  double height_ = 0;
  double wheel_diameter_ = 0;
  double track_ = 0;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_ROBOT_DESCRIPTION_H_
