#include "robot_app/monitoring/diagnostics_monitor.h"

#include <algorithm>
#include <limits>

#include "robot_app/monitoring/gauges/band.h"

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;

constexpr std::size_t kMostStatuses = 2000;  // a limit for a program that invents names

}  // namespace

void DiagnosticsMonitor::Watch(const std::optional<DiagnosticsWatch>& watch, Time now) {
  const auto is_silent = [this, now](const Status& status) {
    return now - status.heard_at > watch_->staleness;
  };
  if (!watch) statuses_.clear();
  if (watch_) {
    statuses_.erase(std::remove_if(statuses_.begin(), statuses_.end(), is_silent), statuses_.end());
  }
  for (Status& status : statuses_) status.was_heard_since_change = false;
  watch_ = watch;
}

void DiagnosticsMonitor::OnStatus(const std::string& name, int level, const std::string& message,
                                  Time now) {
  if (!watch_ || name.rfind(kOwnDiagnostics, 0) == 0) return;
  auto status = std::find_if(statuses_.begin(), statuses_.end(),
                             [&name](const Status& known) { return known.name == name; });
  if (status == statuses_.end()) {
    if (statuses_.size() >= kMostStatuses) return;
    status = statuses_.insert(status, {name, HealthLevel::kOk, "", now});
  }
  status->level = leaves::LevelOfNumber(level);
  status->message = message;
  status->heard_at = now;
  status->was_heard_since_change = true;
}

std::vector<Finding> DiagnosticsMonitor::Report(const ProcessTable&, const Times& now) {
  const auto is_of_another_configuration = [this, &now](const Status& status) {
    return !status.was_heard_since_change && now.wall - status.heard_at > watch_->staleness;
  };
  statuses_.erase(std::remove_if(statuses_.begin(), statuses_.end(), is_of_another_configuration),
                  statuses_.end());
  std::vector<Finding> findings;
  for (const Status& status : statuses_) {
    Finding finding{
        "diagnostics",  status.name, "", status.level, std::numeric_limits<double>::quiet_NaN(), "",
        status.message, now.ros,     ""};
    const Duration silence = now.wall - status.heard_at;
    if (silence > watch_->staleness) {
      finding.level = HealthLevel::kStale;
      finding.message = "not repeated for " + SecondsText(silence);
    }
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace coppice::robot::monitoring
