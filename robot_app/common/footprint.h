// How large the robot is for those who steer it, if no parameter says otherwise.
#ifndef COPPICE_ROBOT_APP_COMMON_FOOTPRINT_H_
#define COPPICE_ROBOT_APP_COMMON_FOOTPRINT_H_

namespace coppice::robot {

/// That of the shipped robot_app/description/sobi.urdf; a test holds it against that.
inline constexpr double kRobotRadius = 0.33;  ///< [m]

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_FOOTPRINT_H_
