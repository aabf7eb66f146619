// Ears and arms as simulated servos: they turn to where they are told no faster than the robot's
// description allows, and not beyond their limits. Not thread-safe.
#ifndef COPPICE_ROBOT_APP_EXPRESSION_LIMBS_H_
#define COPPICE_ROBOT_APP_EXPRESSION_LIMBS_H_

#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/robot_description.h"
#include "robot_app/expression/expression_table.h"

namespace coppice::robot::expression {

class Limbs {
 public:
  /// A problem names the joint of kLimbs that the robot does not have.
  static Expected<Limbs> Of(const RobotDescription& robot);

  /// `seconds` pass.
  void Move(const LimbAngles& targets, double seconds);

  const LimbAngles& angles() const { return angles_; }
  /// The same order as kLimbs.
  const std::vector<JointOnRobot>& joints() const { return joints_; }

 private:
  std::vector<JointOnRobot> joints_;
  LimbAngles angles_{};
};

}  // namespace coppice::robot::expression

#endif  // COPPICE_ROBOT_APP_EXPRESSION_LIMBS_H_
