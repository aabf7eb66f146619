// A clock that runs only while the robot is in motion: most faults come so many times per hour of
// that.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_WORLD_MOVING_CLOCK_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_WORLD_MOVING_CLOCK_H_

#include <functional>
#include <vector>

#include "robot_app/deployment/world/world.h"

namespace coppice::robot::deployment {

class MovingClock {
 public:
  explicit MovingClock(World& world) : world_(world) {}

  /// After so many seconds in motion.
  void After(double seconds, std::function<void()> event);
  void SetMoving(bool is_moving);
  bool is_moving() const { return is_moving_; }
  double seconds() const;  ///< in motion so far

 private:
  struct Alarm {
    double at = 0;
    std::function<void()> event;
  };
  void Plan();
  void Ring();

  World& world_;
  std::vector<Alarm> alarms_;
  bool is_moving_ = false;
  double counted_ = 0;  // s, up to since_
  Time since_{};
  EventQueue::Id planned_{};
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_WORLD_MOVING_CLOCK_H_
