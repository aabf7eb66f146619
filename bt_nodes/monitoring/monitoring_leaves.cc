#include "bt_nodes/monitoring/monitoring_leaves.h"

#include <algorithm>

namespace coppice::leaves {

Status ReadHealth::Run() {
  if (!monitoring.has_value()) return Fail("no monitor has reported yet");
  const double age = std::chrono::duration<double>(now() - monitoring->stamp).count();
  if (age > *max_age) {
    return Fail("the newest report is " + ValueTraits<int>::Print(static_cast<int>(age)) +
                " s old; is the health aggregator running?");
  }
  if (monitoring.writes() == seen_) return Status::kSuccess;
  seen_ = monitoring.writes();
  health.Set(*monitoring);
  errors.Set(static_cast<int>(
      std::count_if(monitoring->entries.begin(), monitoring->entries.end(),
                    [](const HealthEntry& e) { return e.level >= HealthLevel::kError; })));
  return Status::kSuccess;
}

bool FaultCondition::Check() {
  const HealthEntry* error = health->FirstError(monitor_);
  if (!error || (error->level == HealthLevel::kStale && !also_stale_)) return false;
  subject.Set(error->subject);
  node.Set(error->node);
  Say(error->subject + ": " + error->message);
  return true;
}

bool NodeIsWell::Check() {
  const auto blames = [this](const HealthEntry& entry) {
    return entry.level >= HealthLevel::kError && entry.node == *node &&
           ListsKind(*kinds, entry.monitor);
  };
  const auto blame = std::find_if(health->entries.begin(), health->entries.end(), blames);
  if (blame == health->entries.end()) return true;
  Say(*node + ": " + blame->message);
  return false;
}

}  // namespace coppice::leaves
