// The days of a deployment: when the robot is on duty, and which days are weekend. Times are
// nanoseconds since 1970 of the clock on the wall; no time zone, no change of the clocks.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_SCENARIO_CALENDAR_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_SCENARIO_CALENDAR_H_

#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/outcome.h"

namespace coppice::robot::deployment {

/// From a moment on, up to another one.
struct Interval {
  Time from{};
  Time to{};
};

/// "2021-03-02 13:00" or "2021-03-02 13:00:59".
Expected<Time> ParseMoment(std::string_view text);
std::string MomentText(Time moment);

/// Seconds, of the interval alone or of what two have in common.
double SecondsOf(const Interval& interval);
double SecondsIn(const Interval& interval, const Interval& other);
/// How much of an interval is Saturday or Sunday [s].
double WeekendSeconds(const Interval& interval);
/// The calendar's day of a moment: it begins at midnight.
Interval DayAt(Time moment);

class Calendar {
 public:
  Calendar() = default;
  /// `hours`: as in OpenStreetMap (robot_app/knowledge/store/opening_hours.h): "Mo-Fr 09:00-17:00".
  static Expected<Calendar> Make(Interval span, const std::string& hours);

  /// The same up to an earlier end.
  static Expected<Calendar> Cut(Calendar calendar, Time end);

  const Interval& span() const { return span_; }
  /// When the robot is on duty, in order; within the span.
  const std::vector<Interval>& duties() const { return duties_; }
  /// Days of the span on which the robot is on duty.
  int working_days() const { return static_cast<int>(duties_.size()); }

  bool OnDuty(Time now) const { return DutyLeft(now) > 0; }
  /// Until the end of the duty that goes on [s]; 0: none does.
  double DutyLeft(Time now) const;
  /// When the next duty begins or ends after `now`; kNever after the last one.
  Time NextChange(Time now) const;

 private:
  Interval span_;
  std::vector<Interval> duties_;
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_SCENARIO_CALENDAR_H_
