// The robot's monitors and the aggregator of their reports, all in one process: the real judges,
// fed with what the topics of the simulated robot would have carried. A monitor whose program does
// not work says nothing.
//
// They look when there is something to see: of the messages since the last look only those within
// the longest window are fed, for no other is remembered.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_WATCHERS_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_WATCHERS_H_

#include <optional>
#include <string>
#include <vector>

#include "bt_nodes/monitoring/health.h"
#include "robot_app/common/laser_scan.h"
#include "robot_app/deployment/robot/drive.h"
#include "robot_app/deployment/robot/position.h"
#include "robot_app/deployment/robot/programs.h"
#include "robot_app/deployment/robot/station.h"
#include "robot_app/monitoring/aggregator/health_aggregator.h"
#include "robot_app/monitoring/localization_monitor.h"
#include "robot_app/monitoring/monitor_config.h"
#include "robot_app/monitoring/navigation_monitor.h"
#include "robot_app/monitoring/node_monitor.h"
#include "robot_app/monitoring/power/battery_monitor.h"
#include "robot_app/monitoring/power/charging_monitor.h"
#include "robot_app/monitoring/power/docking_monitor.h"
#include "robot_app/monitoring/power/emergency_stop_monitor.h"
#include "robot_app/monitoring/topic_monitor.h"

namespace coppice::robot::deployment {

/// What they look at.
struct Watched {
  const World& world;
  const FloorWays& ways;
  const Programs& programs;
  const Drive& drive;
  const Station& station;
  const Position& position;
};

class Watchers {
 public:
  /// `lost_after`: so long the localization only says that it is not sure [s].
  Watchers(const monitoring::MonitorConfig& config, Watched watched, double lost_after);

  /// What is there to see now; nothing if nobody gathers the reports.
  std::optional<leaves::Health> Look();
  /// Some level has changed with the last look.
  bool has_changed() const { return has_changed_; }
  /// Some level was not OK at the last look.
  bool sees_trouble() const { return sees_trouble_; }
  /// The program that gathers the reports begins anew.
  void ForgetReports();

  Duration period() const { return config_.report_period; }

 private:
  void FollowConfiguration();
  void FeedTopics(const monitoring::Times& now);
  void FeedStates(const monitoring::Times& now);
  void Report(const char* source, const std::vector<monitoring::Monitor*>& monitors,
              const monitoring::Times& now);
  leaves::Health Publish(const monitoring::Times& now);

  const monitoring::MonitorConfig config_;
  const Watched watched_;
  const double lost_after_;
  LaserScan scan_;  // one by which the robot may move
  std::string configuration_ = "?";
  monitoring::ProcessTable processes_;
  monitoring::NodeMonitor nodes_;
  monitoring::TopicMonitor topics_;
  monitoring::NavigationMonitor navigation_;
  monitoring::LocalizationMonitor localization_;
  monitoring::BatteryMonitor battery_;
  monitoring::ChargingMonitor charging_;
  monitoring::DockingMonitor docking_;
  monitoring::EmergencyStopMonitor emergency_stop_;
  std::optional<monitoring::HealthAggregator> aggregator_;
  std::optional<Time> looked_;
  std::string levels_;  // of the last report, one character each
  bool has_changed_ = false;
  bool sees_trouble_ = false;
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_WATCHERS_H_
