// Does the robot get on? Judges what the navigation server says about itself. A robot without a
// goal is well however long it stands; only a goal that cannot be reached is a fault.
//
// ROS time throughout: how long an obstacle may hold the robot is a matter of the world's time.
#ifndef COPPICE_ROBOT_APP_MONITORING_NAVIGATION_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_NAVIGATION_MONITOR_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/monitoring/freshness.h"
#include "robot_app/monitoring/monitor.h"

namespace coppice::robot::monitoring {

/// The numbers are those of coppice_msgs/NavigationState.
enum class NavigationPhase : std::uint8_t { kIdle = 0, kDriving = 1, kBlocked = 2, kNoPath = 3 };

/// A coppice_msgs/NavigationState as a plain value.
struct NavigationReport {
  NavigationPhase phase = NavigationPhase::kIdle;
  Duration in_phase{0};
  std::uint32_t consecutive_failures = 0;
  std::string message;
};

class NavigationMonitor : public Monitor {
 public:
  explicit NavigationMonitor(Duration patience = Duration::zero()) : freshness_(patience) {}

  void Watch(const WatchList& list, const Times&) override { Watch(list.navigation); }
  /// Nothing: navigation is not watched, and nothing is reported.
  void Watch(const std::optional<NavigationWatch>& watch);
  void OnState(NavigationReport state, const Times& now);

  /// Two findings. "navigation": does the robot get on; value: seconds in a bad state; no node is
  /// named, for a restart frees no corridor. "topic": is the state fresh; names the server's node.
  ///
  /// NO_PATH is an error at once if a goal has failed for it, else after its bound, and a warning
  /// before; so is BLOCKED after its bound. A goal that has failed remains an error for some time:
  /// whoever wants to get there will try again soon; and as long as that attempt is BLOCKED before
  /// it has got anywhere.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now) override;

 private:
  Finding Progress(Time now, bool is_fresh) const;

  Freshness freshness_;
  std::optional<NavigationWatch> watch_;
  std::optional<NavigationReport> state_;
  bool has_driven_ = false;  // to the goal that it has
  Time heard_at_{};          // state_
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_NAVIGATION_MONITOR_H_
