#include "robot_app/monitoring/aggregator/diagnostics_messages.h"

#include <ros/time.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include "robot_app/monitoring/diagnostics_monitor.h"

namespace coppice::robot::monitoring {
namespace {

void Add(diagnostic_msgs::DiagnosticStatus& status, const char* key, std::string value) {
  if (value.empty()) return;
  diagnostic_msgs::KeyValue pair;
  pair.key = key;
  pair.value = std::move(value);
  status.values.push_back(std::move(pair));
}

std::string Print(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.9g", number);
  return std::isnan(number) ? "" : text;
}

}  // namespace

diagnostic_msgs::DiagnosticArray ToDiagnostics(const std::vector<Finding>& findings) {
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = ros::Time::now();
  for (const Finding& finding : findings) {
    if (finding.monitor == "diagnostics") continue;
    diagnostic_msgs::DiagnosticStatus status;
    status.name = kOwnDiagnostics + finding.monitor + " " + finding.subject;
    status.level = static_cast<decltype(status.level)>(finding.level);
    status.message = finding.message.empty() ? ToString(finding.level) : finding.message;
    status.hardware_id = finding.host;
    Add(status, "value", Print(finding.value));
    Add(status, "unit", finding.unit);
    Add(status, "node", finding.node);
    array.status.push_back(std::move(status));
  }
  return array;
}

}  // namespace coppice::robot::monitoring
