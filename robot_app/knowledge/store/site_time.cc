#include "robot_app/knowledge/store/site_time.h"

#include <date/tz.h>

#include <array>
#include <cstdio>

namespace coppice::robot::knowledge {
namespace {

date::local_days ToLocalDays(Day day) { return date::local_days(date::days(day.number)); }
Day ToDay(date::local_days days) { return {static_cast<int>(days.time_since_epoch().count())}; }

std::optional<int> Digits(std::string_view text) {
  int number = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    number = 10 * number + (c - '0');
  }
  return number;
}

}  // namespace

CalendarDate DateOf(Day day) {
  const date::year_month_day date(ToLocalDays(day));
  return {static_cast<int>(date.year()), static_cast<int>(static_cast<unsigned>(date.month())),
          static_cast<int>(static_cast<unsigned>(date.day()))};
}

std::optional<Day> DayOf(CalendarDate date) {
  const date::year_month_day day(date::year(date.year),
                                 date::month(static_cast<unsigned>(date.month)),
                                 date::day(static_cast<unsigned>(date.day)));
  if (!day.ok()) return std::nullopt;
  return ToDay(date::local_days(day));
}

int WeekdayOf(Day day) {
  return static_cast<int>(date::weekday(ToLocalDays(day)).iso_encoding()) - 1;
}

std::optional<Day> ParseDay(std::string_view text) {
  std::string digits(text);
  if (text.size() == 10 && text[4] == '-' && text[7] == '-') {
    digits.erase(7, 1).erase(4, 1);
  }
  const std::optional<int> number = Digits(digits);
  if (digits.size() != 8 || !number) return std::nullopt;
  return DayOf({*number / 10000, *number / 100 % 100, *number % 100});
}

std::string IsoText(Day day) {
  const CalendarDate date = DateOf(day);
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02d-%02d", date.year, date.month, date.day);
  return text.data();
}

std::string ClockText(std::chrono::seconds since_midnight) {
  const auto minutes = static_cast<int>(since_midnight.count() / 60 % (24 * 60));
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%02d:%02d", minutes / 60, minutes % 60);
  return text.data();
}

Expected<SiteTime> SiteTime::Find(const std::string& name) {
  try {
    return SiteTime(date::locate_zone(name));
  } catch (const std::exception&) {
    return Problem{"\"" + name + "\" is no time zone, such as Europe/Berlin"};
  }
}

LocalTime SiteTime::Local(WallTime moment) const {
  const auto local = zone_->to_local(date::floor<std::chrono::seconds>(moment));
  const auto day = date::floor<date::days>(local);
  return {ToDay(day), local - day};
}

WallTime SiteTime::OfTimetable(Day day, std::chrono::seconds time) const {
  using std::chrono::hours;
  return zone_->to_sys(ToLocalDays(day) + hours(12)) - hours(12) + time;
}

}  // namespace coppice::robot::knowledge
