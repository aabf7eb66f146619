// Makes contact where there should be one: the robot stands on the station but no current flows.
// It presses on a little, then draws back a little, and watches the battery all the time. Only a
// current that lasts is success.
//
// A deterministic state machine without a clock, a thread or ROS.
#ifndef COPPICE_ROBOT_APP_DOCKING_CONTACT_WIGGLE_H_
#define COPPICE_ROBOT_APP_DOCKING_CONTACT_WIGGLE_H_

#include <string>

#include "robot_app/docking/dock_types.h"

namespace coppice::robot::docking {

class ContactWiggle {
 public:
  explicit ContactWiggle(DockSettings settings = {}) : settings_(settings) {}

  /// Starts anew. When the robot is not on the station this is told by failed after Update().
  void Start(const DockInput& input);

  /// The next command for base_link. To be called at 10 Hz or more while active().
  Velocity2D Update(const DockInput& input);

  bool active() const { return state_ == State::kMoving || state_ == State::kWaiting; }
  bool succeeded() const { return state_ == State::kDone; }
  /// What came of it, for people.
  const std::string& message() const { return message_; }

 private:
  enum class State { kIdle, kMoving, kWaiting, kDone, kFailed };

  bool WatchCurrent(const DockInput& input);
  Velocity2D Move(const DockInput& input);
  void NextMove(const DockInput& input);

  DockSettings settings_;
  State state_ = State::kIdle;
  std::string message_;
  Pose2D start_;
  int move_ = 0;                // counts from 0
  double entered_ = 0;          // when the state began [s]
  double charging_since_ = -1;  // negative: not charging
};

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_CONTACT_WIGGLE_H_
