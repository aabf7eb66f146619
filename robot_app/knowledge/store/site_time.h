// The calendar and the clock of the site. Nothing here reads the computer's clock or its time zone:
// a moment is handed in, the zone is that of the imported files.
//
//   const Expected<SiteTime> berlin = SiteTime::Find("Europe/Berlin");
//   const LocalTime now = berlin->Local(moment);      // the day and the time on the wall
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_STORE_SITE_TIME_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_STORE_SITE_TIME_H_

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "bt_core/base/clock.h"
#include "bt_core/base/outcome.h"

namespace date {
class time_zone;
}

namespace coppice::robot::knowledge {

/// A day of the Gregorian calendar: days since 1970-01-01, which was a Thursday.
struct Day {
  int number = 0;

  Day operator+(int days) const { return {number + days}; }
  bool operator==(Day other) const { return number == other.number; }
  bool operator!=(Day other) const { return number != other.number; }
  bool operator<(Day other) const { return number < other.number; }
  bool operator<=(Day other) const { return number <= other.number; }
};

struct CalendarDate {
  int year = 1970;
  int month = 1;  ///< from 1
  int day = 1;    ///< from 1
};

CalendarDate DateOf(Day day);
/// Nothing if there is no such day.
std::optional<Day> DayOf(CalendarDate date);
/// From 0, Monday, to 6.
int WeekdayOf(Day day);
/// "2026-11-25", or as in GTFS "20261125"; nothing if it is no day.
std::optional<Day> ParseDay(std::string_view text);
std::string IsoText(Day day);

/// What clocks on the wall show.
struct LocalTime {
  Day day;
  std::chrono::seconds time{0};  ///< since midnight
};

/// "14:05".
std::string ClockText(std::chrono::seconds since_midnight);

/// A time zone of the system's database (Debian's tzdata).
class SiteTime {
 public:
  static Expected<SiteTime> Find(const std::string& name);

  LocalTime Local(WallTime moment) const;
  /// The moment that a timetable of a day means: so long after noon minus 12 hours, which is
  /// midnight but on days when the clocks change (GTFS reference, "Time"). May exceed 24 h.
  WallTime OfTimetable(Day day, std::chrono::seconds time) const;

 private:
  explicit SiteTime(const date::time_zone* zone) : zone_(zone) {}
  const date::time_zone* zone_;  // of the library, for as long as the program runs
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_STORE_SITE_TIME_H_
