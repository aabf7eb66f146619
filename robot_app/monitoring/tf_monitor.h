// Are the transforms between frames there, fresh, steady, and still between the same frames?
//
// ROS time, as transforms are stamped in it; but one that is not renewed ages in ROS time or in
// wall time, whichever is less (silence.h).
#ifndef COPPICE_ROBOT_APP_MONITORING_TF_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_TF_MONITOR_H_

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/monitoring/gauges/gauge_board.h"
#include "robot_app/monitoring/gauges/patience.h"
#include "robot_app/monitoring/monitor.h"

namespace coppice::robot::monitoring {

/// One look at a pair of frames.
struct TransformSample {
  Time stamp{};                ///< of the newest common time; zero: static
  double x = 0, y = 0, z = 0;  ///< of the child in the parent [m]
  std::string hangs_on;        ///< frame that the child is a direct child of
};

class TfMonitor : public Monitor {
 public:
  explicit TfMonitor(Duration patience = Duration::zero()) : patience_(patience) {}

  void Watch(const WatchList& list, const Times&) override { Watch(list.transforms); }
  /// Watches these pairs from now on; a pair that stays the same keeps what was seen.
  void Watch(const std::vector<TransformWatch>& pairs);

  /// The pairs to look at, in the order that OnSamples expects.
  std::vector<std::pair<std::string, std::string>> Pairs() const;
  void OnSamples(const std::vector<Expected<TransformSample>>& samples, const Times& now);

  /// Per pair, "map -> odom age" (also an error if it is not found for the staleness), "... jump"
  /// (m since the look before, less what it can have driven in that time) and "... parent" (an
  /// error once the child hangs on another frame than at first). Only the age names the node: a
  /// restart mends no tree with two owners.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now) override;

 private:
  struct Pair {
    TransformWatch watch;
    Judge age, jump;
    Patience patience;
    std::optional<TransformSample> last;
    Times renewed;             // when the last one was new
    Duration age_then{0};      // and how old it was
    std::string first_parent;  // of the child
    std::string problem;       // of the last look
  };
  static void OnSample(Pair& pair, const Expected<TransformSample>& look, const Times& now);
  static Duration AgeOf(Pair& pair, const TransformSample& sample, const Times& now);
  static void CompareWithLast(Pair& pair, const TransformSample& sample, Time now);
  static Finding About(const Pair& pair, const std::string& what, Time now);
  void Report(Pair& pair, const ProcessTable& processes, const Times& now,
              std::vector<Finding>& findings) const;

  Duration patience_;
  std::vector<Pair> pairs_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_TF_MONITOR_H_
