#include "robot_app/expression/limbs.h"

#include <algorithm>

namespace coppice::robot::expression {

Expected<Limbs> Limbs::Of(const RobotDescription& robot) {
  Limbs limbs;
  for (const char* name : kLimbs) {
    const auto joint = std::find_if(robot.joints().begin(), robot.joints().end(),
                                    [&](const JointOnRobot& one) { return one.name == name; });
    if (joint == robot.joints().end()) {
      return Problem{"the robot has no joint \"" + std::string(name) + "\" with limits"};
    }
    limbs.joints_.push_back(*joint);
  }
  return limbs;
}

void Limbs::Move(const LimbAngles& targets, double seconds) {
  for (std::size_t i = 0; i < angles_.size(); ++i) {
    const JointOnRobot& joint = joints_[i];
    const double most = joint.velocity * seconds;
    const double target = std::clamp(targets[i], joint.lower, joint.upper);
    angles_[i] += std::clamp(target - angles_[i], -most, most);
  }
}

}  // namespace coppice::robot::expression
