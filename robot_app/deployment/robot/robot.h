// The robot in one process under simulated time, for one seed: the shipped trees and leaves,
// process supervisor, monitors, aggregator and help desk as they are, on a body, programs and
// people at the level of events. Deterministic: the same scenario, seed and controller give the
// same journal.
//
// It jumps from one event to the next: what happens in the world, a timer of a tree, a look of the
// monitors. Those look every report_period as long as something goes on, and once a minute while
// all is well; before the monitor tree is ticked they always look.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_ROBOT_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_ROBOT_H_

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt_nodes/people/people_view.h"
#include "robot_app/common/configuration/site_phrases.h"
#include "robot_app/common/places/site_places.h"
#include "robot_app/deployment/robot/drive.h"
#include "robot_app/deployment/robot/fault_plan.h"
#include "robot_app/deployment/robot/helpers.h"
#include "robot_app/deployment/robot/keeper.h"
#include "robot_app/deployment/robot/manager.h"
#include "robot_app/deployment/robot/position.h"
#include "robot_app/deployment/robot/programs.h"
#include "robot_app/deployment/robot/shipped.h"
#include "robot_app/deployment/robot/station.h"
#include "robot_app/deployment/robot/surface.h"
#include "robot_app/deployment/robot/trees.h"
#include "robot_app/deployment/robot/watchers.h"
#include "robot_app/deployment/world/moving_clock.h"

namespace coppice::robot::deployment {

class Robot {
 public:
  /// `record`: records are named after it (`record`.application.coppice ...); empty: none. All must
  /// live as long as the robot. Throws std::runtime_error if a tree cannot run.
  Robot(World& world, const Shipped& shipped, const Controller& controller, std::string record);

  /// Up to the end of the calendar. `progress`: called now and then.
  void Run(const std::function<void(Time now)>& progress = {});

 private:
  // What a tree is fed with.
  struct Keys {
    Sender<double> battery_level, distance_to_station, duty_left;
    Sender<bool> charging, docked, manual;
    Sender<leaves::Health> monitoring;
    Sender<std::string> configuration, processes;
    Sender<leaves::BatteryReading> battery;
    Sender<leaves::Pose2D> pose;
    Sender<leaves::PeopleView> people;
  };

  void Wire();
  void StartTrees();
  void StopTrees();
  std::unique_ptr<Tree> MakeTree(const std::string& name, const std::string& file);
  static Keys KeysOf(Executor& executor);
  void ShowFace(bool has_mask);

  void StepParts();
  void Look();
  void Feed(const Keys& keys, bool is_application) const;
  void FeedPose(const Keys& keys) const;
  void TickTrees();
  void Judge();
  void Advance();
  void LiveThrough(double seconds);
  double LookPeriod() const;
  bool IsInTrouble() const;
  void Notice() { noticed_ = world_.now(); }

  void OnReady(const std::string& node, bool is_cleared);
  void Help(const std::string& subject);
  void PutRight();
  void SwitchOff();

  World& world_;
  const Shipped& shipped_;
  const Controller& controller_;
  const std::string record_;
  FloorWays ways_;
  MovingClock moving_;
  Programs programs_;
  Drive drive_;
  Station station_;
  Position position_;
  Helpers helpers_;
  Watchers watchers_;
  FaultPlan faults_;
  Keeper keeper_;
  SitePlaces places_;
  SitePhrases phrases_;
  Surface surface_;
  Manager manager_;
  Link link_;
  std::unique_ptr<Tree> application_, monitor_;
  std::vector<Keys> keys_;  // of the application, of the monitor
  int starts_ = 0;          // of the trees
  Time next_look_{}, noticed_{};
  bool has_errors_ = false;  // at the last look
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_ROBOT_H_
