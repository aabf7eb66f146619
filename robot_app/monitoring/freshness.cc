#include "robot_app/monitoring/freshness.h"

#include <utility>

#include "robot_app/monitoring/gauges/band.h"

namespace coppice::robot::monitoring {

Finding Freshness::Assess(Finding finding, Duration staleness, const std::string& what,
                          const ProcessTable& processes, const Times& now) {
  const Duration silence = silence_.Lasted(now);
  finding.value = InSeconds(silence);
  finding.unit = "s";
  finding.stamp = now.ros;
  if (silence > staleness) {
    finding.level = leaves::HealthLevel::kError;
    finding.message = what + " for " + SecondsText(silence);
  }
  lasting_.Apply(finding, now.wall, patience_);
  ApplyGrace(processes, finding.node, finding);
  return finding;
}

}  // namespace coppice::robot::monitoring
