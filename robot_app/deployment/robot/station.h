// The charging station at the level of events: attempts that fail, contacts without current, and
// what the docking server tells of itself.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_STATION_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_STATION_H_

#include <functional>
#include <string>
#include <vector>

#include "bt_nodes/docking/charging_station.h"
#include "robot_app/deployment/robot/programs.h"
#include "robot_app/deployment/scenario/chance.h"
#include "robot_app/deployment/world/world.h"
#include "robot_app/monitoring/power/docking_monitor.h"

namespace coppice::robot::deployment {

class Station : public leaves::ChargingStation {
 public:
  /// `contact_is_success`: as published, where current is not looked at.
  Station(World& world, const Programs& programs, Pose2D docked, Pose2D staging,
          bool contact_is_success);

  void Dock(double lateral_offset, int attempts, Sender<leaves::ActionResult> done) override;
  void PressOn(Sender<leaves::ActionResult> done) override;
  void Undock(Sender<leaves::ActionResult> done) override;
  void CancelDocking() override;

  /// A person repairs the station, and pushes the robot onto it if it is to be there.
  void Repair(bool push_onto_it);

  /// What a monitor sees: the newest goal.
  std::vector<monitoring::GoalReport> goals() const { return {goal_}; }
  int failed_attempts() const { return failed_; }
  bool is_busy() const { return is_busy_; }

  std::function<void()> on_contact;  ///< contact was made or lost

 private:
  void Begin(Sender<leaves::ActionResult> done);
  void After(double seconds, std::function<void()> event);
  void Attempt();
  void FailAttempt(const std::string& why);
  void Finish(bool ok, const std::string& message);
  void Contact();
  void Leave();
  void TryToPressOn(std::function<void()> otherwise);
  void CloseVisit();
  Docking* visit();

  World& world_;
  const Programs& programs_;
  const Pose2D docked_, staging_;
  const bool contact_is_success_;
  Chance chance_;

  Sender<leaves::ActionResult> done_;
  EventQueue::Id next_{};
  bool is_busy_ = false;
  int attempts_left_ = 0;
  int failed_ = 0;
  bool had_contact_ = false;    // in this visit
  bool visit_is_open_ = false;  // the last entry of the journal
  monitoring::GoalReport goal_;
  int goals_ = 0;
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_STATION_H_
