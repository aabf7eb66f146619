// Brings the reports of all monitors together into one state of health.
//
// Severity survives: what was once an error is seen as one at least once, however short it was and
// however late the reader looks. Silence is a fault: a monitor that no longer reports makes its
// entries STALE, so that a dead monitor cannot pass for a healthy robot.
//
// All times are wall time: the reports have wall-time periods.
#ifndef COPPICE_ROBOT_APP_MONITORING_AGGREGATOR_HEALTH_AGGREGATOR_H_
#define COPPICE_ROBOT_APP_MONITORING_AGGREGATOR_HEALTH_AGGREGATOR_H_

#include <optional>
#include <string>
#include <vector>

#include "robot_app/monitoring/gauges/finding.h"
#include "robot_app/monitoring/gauges/watch.h"
#include "robot_app/monitoring/process_table.h"

namespace coppice::robot::monitoring {

class HealthAggregator {
 public:
  /// A level that is worse than the current one is shown in one publication at least, and for
  /// `hold` after it was seen. A source is silent after `silent_periods` of its periods.
  HealthAggregator(Duration hold, int silent_periods)
      : hold_(hold), silent_periods_(silent_periods) {}

  /// These sources must report from now on. Others may; what they say is passed through, with an
  /// entry of monitor "aggregation" that says so. One that was expected and no longer is has some
  /// time to end, in which it is ignored.
  void Expect(const std::vector<SourceWatch>& sources, Time now);

  /// The complete report of a source: what it no longer mentions is forgotten. True if a level
  /// has changed and should be published at once.
  bool OnReport(const std::string& source, const std::vector<Finding>& findings, Time now);

  /// Looks for silent sources, with grace for those that are being started. True if one has fallen
  /// silent since the last call. `stamp`: ROS time.
  bool CheckSilence(const ProcessTable& processes, Time now, Time stamp);

  /// Everything that is known now, sources in the order of their first report. A silent source
  /// has an entry of its own, monitor "node"; it is the node to restart for all its entries. An
  /// unknown source that is silent is restarted by nobody, and forgotten after a while. `stamp`:
  /// ROS time.
  std::vector<Finding> Publish(Time now, Time stamp);

 private:
  struct Entry {
    Finding current;
    Finding worst;
    Time worst_at{};
    bool worst_is_new = false;  // not yet published
    bool is_published = false;
    leaves::HealthLevel published = leaves::HealthLevel::kOk;
  };
  struct Source {
    std::string name;
    Duration period{0};
    bool expected = false;
    bool silent = false;
    Time last_report{};
    std::optional<Time> dismissed_at;  // expected before, and no longer
    std::string host;
    std::vector<Entry> entries;
  };

  Source& Get(const std::string& name, Time now);
  static bool Update(Entry& entry, const Finding& finding, Time now);
  static void MakeStale(Source& source, Time now, Time stamp);
  void ForgetStrangers(Time now);

  Duration hold_;
  int silent_periods_;
  std::vector<Source> sources_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_AGGREGATOR_HEALTH_AGGREGATOR_H_
