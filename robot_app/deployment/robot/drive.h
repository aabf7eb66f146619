// Driving to poses and small motions at the level of events: the way is that of the real planner on
// the real floor, how long it takes and what holds the robot on it is modelled. Its patience is
// that of the real navigation (NavigationSettings).
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_DRIVE_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_DRIVE_H_

#include <functional>
#include <optional>
#include <string>

#include "bt_nodes/navigation/navigator.h"
#include "robot_app/deployment/robot/programs.h"
#include "robot_app/deployment/world/floor_ways.h"
#include "robot_app/deployment/world/world.h"
#include "robot_app/monitoring/navigation_monitor.h"

namespace coppice::robot::deployment {

class Drive : public leaves::Navigator {
 public:
  /// `abort_after`: a goal is given up when it was held for so long [s].
  Drive(World& world, FloorWays& ways, const Programs& programs, double abort_after);

  void NavigateTo(const leaves::Pose2D& goal, Sender<leaves::ActionResult> done) override;
  void CancelNavigation() override;
  void LimitSpeed(double) override {}
  void FindWay(const leaves::Pose2D& goal, Sender<leaves::ActionResult> done) override;
  void Move(double distance, double speed, Sender<leaves::ActionResult> done) override;
  void Rotate(double angle, double speed, Sender<leaves::ActionResult> done) override;
  void CancelMotion() override;

  /// What is true has changed: a hindrance, a program, the position.
  void Review();
  /// The robot is put somewhere by somebody.
  void PutAt(const Pose2D& pose);

  /// What is left of the way; empty if it drives nowhere.
  FloorWays::Way WayLeft() const;
  bool has_goal() const { return goal_.has_value(); }
  monitoring::NavigationReport report() const;

  std::function<void(double distance)> on_moved;  ///< a small motion has ended
  std::function<void()> on_rotated;

 private:
  using Phase = monitoring::NavigationPhase;
  void BeginWay();
  std::string WhyHeld() const;
  void Roll();
  void Hold(const std::string& why);
  void SetPhase(Phase phase, const std::string& message);
  void Finish(bool ok, const std::string& message);
  void BeginMotion(double seconds, std::function<void()> at_end, Sender<leaves::ActionResult> done);
  void TakePlace();
  bool Runs() const;

  World& world_;
  FloorWays& ways_;
  const Programs& programs_;
  const double abort_after_;

  std::optional<Pose2D> goal_;
  Sender<leaves::ActionResult> done_;
  FloorWays::Way way_;
  double along_ = 0;  // m of the way, at rolls_since_
  Time rolls_since_{};
  EventQueue::Id arrival_{}, abort_{};
  bool is_held_ = false;

  Phase phase_ = Phase::kIdle;
  Time phase_since_{};
  std::string message_;
  std::uint32_t failures_ = 0;

  bool is_in_motion_ = false;  // a small one
  Sender<leaves::ActionResult> motion_done_;
  EventQueue::Id motion_end_{};
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_DRIVE_H_
