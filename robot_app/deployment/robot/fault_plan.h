// What goes wrong, and when: the faults of the scenario, each from a stream of chance of its own.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_FAULT_PLAN_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_FAULT_PLAN_H_

#include <functional>
#include <string>

#include "robot_app/deployment/robot/drive.h"
#include "robot_app/deployment/robot/position.h"
#include "robot_app/deployment/robot/programs.h"
#include "robot_app/deployment/scenario/chance.h"
#include "robot_app/deployment/world/floor_ways.h"
#include "robot_app/deployment/world/moving_clock.h"
#include "robot_app/deployment/world/world.h"

namespace coppice::robot::deployment {

class FaultPlan {
 public:
  FaultPlan(World& world, MovingClock& moving, FloorWays& ways, Drive& drive, Position& position,
            Programs& programs);

  /// Plans all that is to happen.
  void Begin();
  /// What holds the robot has gone; it may come again nearby.
  void ClearHindrance();
  /// A small motion of the robot has ended.
  void OnMoved(double distance);

  std::function<void()> on_fault;  ///< something has begun or ended
  /// A face was seen; called for each.
  std::function<void(bool has_mask)> on_face;

 private:
  using Act = void (FaultPlan::*)();
  void PerHour(Fault fault, Chance& chance, Act act);
  void PerDeployment(Fault fault, bool on_duty, std::function<void()> act);
  Time SomeTime(Chance& chance, bool on_duty) const;
  void Faces();
  void BeginHindrance();
  bool BeginClosed();
  void LosePosition();
  void FailProgram();
  void FailTopic();
  void Note(Fault fault, const std::string& what, double lasts = 0);
  std::string SomeNode(Chance& chance) const;
  double Crowd() const;
  void Tell() {
    if (on_fault) on_fault();
  }

  World& world_;
  MovingClock& moving_;
  FloorWays& ways_;
  Drive& drive_;
  Position& position_;
  Programs& programs_;
  Chance blockages_, losses_, failures_, topics_, rare_, faces_, sight_;
  EventQueue::Id clears_{};
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_FAULT_PLAN_H_
