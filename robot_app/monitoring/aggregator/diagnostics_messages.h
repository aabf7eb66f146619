// The robot's health as ROS users expect it: on /diagnostics, for rqt_robot_monitor and the like.
#ifndef COPPICE_ROBOT_APP_MONITORING_AGGREGATOR_DIAGNOSTICS_MESSAGES_H_
#define COPPICE_ROBOT_APP_MONITORING_AGGREGATOR_DIAGNOSTICS_MESSAGES_H_

#include <diagnostic_msgs/DiagnosticArray.h>

#include <vector>

#include "robot_app/monitoring/gauges/finding.h"

namespace coppice::robot::monitoring {

/// One status per finding, named "coppice: <monitor> <subject>", hardware_id: the host; the number
/// and the rest as key-values. What came from /diagnostics is left out: it is there already.
diagnostic_msgs::DiagnosticArray ToDiagnostics(const std::vector<Finding>& findings);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_AGGREGATOR_DIAGNOSTICS_MESSAGES_H_
