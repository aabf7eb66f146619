// Is there news of something? An error once nothing was heard for too long; not while its node
// starts, and for a hiccup of the computer only a warning (patience.h).
#ifndef COPPICE_ROBOT_APP_MONITORING_FRESHNESS_H_
#define COPPICE_ROBOT_APP_MONITORING_FRESHNESS_H_

#include <string>

#include "robot_app/monitoring/gauges/patience.h"
#include "robot_app/monitoring/gauges/silence.h"
#include "robot_app/monitoring/process_table.h"

namespace coppice::robot::monitoring {

class Freshness {
 public:
  /// `patience`: how long an error is only a warning, wall time.
  explicit Freshness(Duration patience, SilenceIn time = SilenceIn::kEitherTime)
      : patience_(patience), silence_(time) {}

  void OnMessage(const Times& now) { silence_.OnMessage(now); }
  /// Silence counts anew from the next look on.
  void Reset() { silence_.Reset(); }
  /// So long nothing was heard (silence.h).
  Duration Lasted(const Times& now) { return silence_.Lasted(now); }

  /// Completes a finding about `finding.node`: value, level, and "`what` for 5 s".
  Finding Assess(Finding finding, Duration staleness, const std::string& what,
                 const ProcessTable& processes, const Times& now);

 private:
  Duration patience_;
  Patience lasting_;
  Silence silence_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_FRESHNESS_H_
