#include "robot_app/monitoring/diagnostics_monitor.h"

#include <algorithm>
#include <limits>

#include "bt_core/model/utf8.h"
#include "robot_app/monitoring/gauges/band.h"

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;

constexpr std::size_t kMostStatuses = 2000;  // a limit for a program that invents names
constexpr Duration kRefusalsShown = std::chrono::minutes(1);
constexpr std::size_t kLongestName = 200, kLongestMessage = 1000;  // bytes; all is told on often

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
  Status* const status = Of(PlainText(name, kLongestName), now);
  if (status == nullptr) return;
  status->level = leaves::LevelOfNumber(level);
  status->message = PlainText(message, kLongestMessage);
  status->heard_at = now;
  status->was_heard_since_change = true;
}

// Null if there are too many. Who is silent makes room: with names that are invented nobody hides
// for ever what others say.
DiagnosticsMonitor::Status* DiagnosticsMonitor::Of(const std::string& name, Time now) {
  const auto known = std::find_if(statuses_.begin(), statuses_.end(),
                                  [&name](const Status& status) { return status.name == name; });
  if (known != statuses_.end()) return &*known;
  if (statuses_.size() < kMostStatuses) {
    statuses_.push_back({name, HealthLevel::kOk, "", now});
    return &statuses_.back();
  }
  refused_at_ = now;
  const auto oldest =
      std::min_element(statuses_.begin(), statuses_.end(),
                       [](const Status& a, const Status& b) { return a.heard_at < b.heard_at; });
  if (now - oldest->heard_at <= watch_->staleness) return nullptr;
  *oldest = {name, HealthLevel::kOk, "", now};
  return &*oldest;
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
  if (refused_at_ && now.wall - *refused_at_ <= kRefusalsShown) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    findings.push_back(
        {"diagnostics", "/diagnostics", "", HealthLevel::kWarn, none, "",
         "more than " + std::to_string(kMostStatuses) + " names: not all that is said is heard",
         now.ros, ""});
  }
  return findings;
}

}  // namespace coppice::robot::monitoring
