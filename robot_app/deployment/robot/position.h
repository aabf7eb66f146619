// Knowing where it is: the localization at the level of events. It loses the position for one of
// three reasons and finds it again by what helps against that one.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_POSITION_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_POSITION_H_

#include <functional>

#include "robot_app/deployment/world/world.h"
#include "robot_app/monitoring/localization_monitor.h"

namespace coppice::robot::deployment {

class Position {
 public:
  explicit Position(World& world) : world_(world) {}

  void Lose(Loss loss) {
    if (world_.loss != Loss::kNone || world_.docked) return;
    world_.loss = loss;
    world_.lost_at = world_.now();
    Tell();
  }
  /// The robot has turned once around itself.
  void OnRotated() {
    if (world_.loss == Loss::kTransient) Find();
  }
  /// The program was started again; on the station it begins at the station.
  void OnRestarted(bool is_cleared) {
    if (world_.docked) Find();
    if (world_.loss == Loss::kInside && is_cleared) world_.loss = Loss::kTransient;
  }
  void Find() {
    world_.loss = Loss::kNone;
    Tell();
  }

  /// `lost_after`: so long it only says that it is not sure [s].
  monitoring::LocalizationReading reading(double lost_after) const {
    using Phase = monitoring::LocalizationReading::Phase;
    if (world_.loss == Loss::kNone) return {Phase::kOk, 0, 0.9, 0.05, ""};
    const double since = SecondsOf({world_.lost_at, world_.now()});
    const Phase phase = since < lost_after ? Phase::kUncertain : Phase::kLost;
    return {phase, since, 0.3, 0.05, "the scan agrees badly"};
  }

  std::function<void()> on_change;

 private:
  void Tell() {
    if (on_change) on_change();
  }
  World& world_;
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_POSITION_H_
