// Errors in ROS time need a second opinion in wall time: when simulated time runs eight times as
// fast, a busy computer's hiccup of 0.2 s looks like a silence of 1.6 s. What is an error now is
// reported as a warning until it has lasted for a while of wall time.
#ifndef COPPICE_ROBOT_APP_MONITORING_GAUGES_PATIENCE_H_
#define COPPICE_ROBOT_APP_MONITORING_GAUGES_PATIENCE_H_

#include <optional>

#include "robot_app/monitoring/gauges/finding.h"

namespace coppice::robot::monitoring {

/// For one subject.
class Patience {
 public:
  /// Turns an error into a warning unless all findings of at least `patience` were errors. `now`:
  /// wall time.
  void Apply(Finding& finding, Time now, Duration patience) {
    if (finding.level < leaves::HealthLevel::kError) {
      bad_since_.reset();
      return;
    }
    if (!bad_since_) bad_since_ = now;
    if (now - *bad_since_ < patience) finding.level = leaves::HealthLevel::kWarn;
  }

 private:
  std::optional<Time> bad_since_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_GAUGES_PATIENCE_H_
