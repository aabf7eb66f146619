// Many numbers, each judged by its own band: the common part of the monitors that measure.
//
//   board.Watch({{"memory", "used", "", "", {{{}, 0.8}, {{}, 0.95}}}});
//   board.OnValue("memory", "used", 0.97, now);
//   board.Report(now);  // one finding, an error
#ifndef COPPICE_ROBOT_APP_MONITORING_GAUGES_GAUGE_BOARD_H_
#define COPPICE_ROBOT_APP_MONITORING_GAUGES_GAUGE_BOARD_H_

#include <string>
#include <vector>

#include "robot_app/monitoring/gauges/band.h"
#include "robot_app/monitoring/gauges/finding.h"

namespace coppice::robot::monitoring {

/// A number that is watched.
struct GaugeWatch {
  std::string monitor;  ///< kind of monitor
  std::string subject;  ///< unique within the kind
  std::string node;     ///< ROS node to restart when it is an error; empty if none
  std::string unit;
  Band band;
};

/// All times are of one time line, whichever the caller uses.
class GaugeBoard {
 public:
  /// Watches these from now on; what is known about those that stay the same is kept.
  void Watch(const std::vector<GaugeWatch>& gauges);

  /// A number that is not watched is ignored.
  void OnValue(const std::string& monitor, const std::string& subject, double value, Time now);
  /// The attempt to measure it has failed.
  void OnFailure(const std::string& monitor, const std::string& subject, const std::string& why,
                 Time now);
  /// Forgets what was seen of all.
  void Reset();

  /// One finding per number, in the order of Watch; `stamp`: ROS time. A gauge that has had no
  /// value has the value NaN.
  std::vector<Finding> Report(Time now, Time stamp);

 private:
  struct Gauge {
    GaugeWatch watch;
    Judge judge;
  };
  Gauge* Find(const std::string& monitor, const std::string& subject);

  std::vector<Gauge> gauges_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_GAUGES_GAUGE_BOARD_H_
