// Keeps the journal of a deployment, and stands for whoever comes without having been asked: when
// the robot is off, stands for long without a word, or is about to lose its battery, somebody
// notices and puts it right. That is an unplanned stop, whatever drives the robot.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_KEEPER_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_KEEPER_H_

#include <functional>
#include <optional>
#include <string>

#include "robot_app/deployment/robot/helpers.h"
#include "robot_app/deployment/robot/programs.h"
#include "robot_app/deployment/world/moving_clock.h"
#include "robot_app/deployment/world/world.h"

namespace coppice::robot::deployment {

class Keeper {
 public:
  Keeper(World& world, MovingClock& moving, const Programs& programs, Helpers& helpers);

  /// What the robot is about now. `in_trouble`: in an error or a recovery.
  void Note(bool in_trouble, bool is_going_home);
  /// The end.
  void Close();
  /// The tenth restart of a program that crashes after every start.
  void OnLoopNoticed();

  std::function<void()> on_intervention;  ///< everything is put right by hand

 private:
  Activity ActivityNow(bool in_trouble) const;
  void NoteStanding(Activity activity);
  void Watch(Activity activity, bool is_going_home);
  std::string Cause() const;
  void Intervene();

  World& world_;
  MovingClock& moving_;
  const Programs& programs_;
  Helpers& helpers_;
  std::optional<Time> stands_since_;
  std::optional<EventQueue::Id> coming_;  // somebody has noticed
  std::string cause_, what_;
  Time sampled_{};
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_KEEPER_H_
