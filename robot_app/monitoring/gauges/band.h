// How a measured number is judged: the one rule that all numeric monitors share.
//
//   Judge judge({{20, 25}, {18, 28}, 2});  // warning outside 20..25, error outside 18..28, twice
//   judge.OnValue(17.5, now);
//   judge.Assess(now).level;               // kWarn: seen once
#ifndef COPPICE_ROBOT_APP_MONITORING_GAUGES_BAND_H_
#define COPPICE_ROBOT_APP_MONITORING_GAUGES_BAND_H_

#include <optional>
#include <string>

#include "bt_core/base/clock.h"
#include "bt_nodes/monitoring/health.h"

namespace coppice::robot::monitoring {

/// Two-sided bounds. A number exactly on a bound is still within; a missing bound never alarms.
struct Range {
  std::optional<double> low, high;

  /// NaN is within no range that has a bound.
  bool Contains(double value) const;
  bool operator==(const Range& other) const { return low == other.low && high == other.high; }
};

struct Band {
  Range warn, error;
  /// So many values in a row outside `error` are an error, fewer a warning; so many outside `warn`
  /// are a warning, fewer are nothing. One good value ends both.
  int consecutive = 1;
  Duration staleness{0};  ///< no value for longer than this is an error; zero: silence is allowed
  double hysteresis = 0;  ///< a bad level ends only so far within the bound that began it

  bool operator==(const Band& other) const {
    return warn == other.warn && error == other.error && consecutive == other.consecutive &&
           staleness == other.staleness && hysteresis == other.hysteresis;
  }
};

/// Bands with bounds on one side only, that need no news.
Band AtMost(double warn, double error, int consecutive = 1);
Band AtLeast(double warn, double error, int consecutive = 1, double hysteresis = 0);

/// Does it judge values at all?
bool HasBounds(const Band& band);

/// What is to be said about a number.
struct Assessment {
  leaves::HealthLevel level = leaves::HealthLevel::kOk;
  std::string message;  ///< why; empty if all is well
};

class Judge {
 public:
  /// `unit`: of the values, for the messages.
  explicit Judge(Band band = {}, std::string unit = {});

  void OnValue(double value, Time now);
  /// The attempt to measure failed: counts as a value outside `error`.
  void OnFailure(const std::string& why, Time now);
  /// Silence counts from the first assessment on. Time that jumps back starts it anew.
  Assessment Assess(Time now);
  /// Forgets what was seen, the silence too.
  void Reset();

  const Band& band() const { return band_; }
  std::optional<double> value() const { return value_; }

 private:
  void Count(leaves::HealthLevel level);

  Band band_;
  std::string unit_;
  std::optional<double> value_;    // the last one
  std::string failure_;            // of the last attempt; empty if it had a value
  std::optional<Time> heard_at_;   // the last value or attempt, else the first assessment
  int errors_ = 0, warnings_ = 0;  // in a row
  leaves::HealthLevel level_ = leaves::HealthLevel::kOk;
};

/// "5 to 15 Hz", "at most 0.9", "at least 23 V".
std::string ToText(const Range& range, const std::string& unit);
/// Three significant digits.
std::string ToText(double number);

double InSeconds(Duration duration);
/// "2.5 s".
std::string SecondsText(Duration duration);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_GAUGES_BAND_H_
