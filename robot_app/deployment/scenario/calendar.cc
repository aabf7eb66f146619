#include "robot_app/deployment/scenario/calendar.h"

#include <algorithm>
#include <cstdio>

#include "robot_app/knowledge/store/opening_hours.h"

namespace coppice::robot::deployment {
namespace {

constexpr Duration kDay = std::chrono::hours(24);

Time BeginOf(knowledge::Day day) { return Time(kDay * day.number); }

knowledge::Day DayOf(Time moment) { return {static_cast<int>(moment.time_since_epoch() / kDay)}; }

}  // namespace

Expected<Time> ParseMoment(std::string_view text) {
  const std::string copy(text);
  int hour = 0, minute = 0, second = 0;
  const int read = copy.size() < 16
                       ? 0
                       : std::sscanf(copy.c_str() + 10, " %2d:%2d:%2d", &hour, &minute, &second);
  const auto day = knowledge::ParseDay(text.substr(0, 10));
  const bool is_time = read >= 2 && hour >= 0 && hour < 24 && minute >= 0 && minute < 60 &&
                       second >= 0 && second < 60;
  if (!day || !is_time) {
    return Problem{"\"" + copy + "\" is no moment, expected \"2021-03-02 13:00\""};
  }
  return BeginOf(*day) + std::chrono::hours(hour) + std::chrono::minutes(minute) +
         std::chrono::seconds(second);
}

std::string MomentText(Time moment) {
  const knowledge::Day day = DayOf(moment);
  const auto time = std::chrono::duration_cast<std::chrono::seconds>(moment - BeginOf(day));
  char text[16];
  std::snprintf(text, sizeof text, ":%02d", static_cast<int>(time.count() % 60));
  return knowledge::IsoText(day) + " " + knowledge::ClockText(time) + text;
}

double SecondsOf(const Interval& interval) {
  return std::chrono::duration<double>(interval.to - interval.from).count();
}

double SecondsIn(const Interval& interval, const Interval& other) {
  return std::max(
      0.0, SecondsOf({std::max(interval.from, other.from), std::min(interval.to, other.to)}));
}

double WeekendSeconds(const Interval& interval) {
  double seconds = 0;
  for (knowledge::Day day = DayOf(interval.from); BeginOf(day) < interval.to; day = day + 1) {
    if (WeekdayOf(day) < 5) continue;
    seconds += SecondsIn(interval, {BeginOf(day), BeginOf(day + 1)});
  }
  return seconds;
}

Interval DayAt(Time moment) {
  const knowledge::Day day = DayOf(moment);
  return {BeginOf(day), BeginOf(day + 1)};
}

Expected<Calendar> Calendar::Make(Interval span, const std::string& hours) {
  const auto opening = knowledge::OpeningHours::Parse(hours);
  if (!opening) return Problem{opening.problem()};
  if (span.to <= span.from) return Problem{"it ends before it begins"};
  Calendar calendar;
  calendar.span_ = span;
  for (knowledge::Day day = DayOf(span.from); BeginOf(day) < span.to; day = day + 1) {
    for (const knowledge::OpenSpan& open : opening->On(day, false)) {
      const Interval duty{std::max(span.from, BeginOf(day) + open.from),
                          std::min(span.to, BeginOf(day) + open.to)};
      if (duty.from < duty.to) calendar.duties_.push_back(duty);
    }
  }
  return calendar;
}

Expected<Calendar> Calendar::Cut(Calendar calendar, Time end) {
  if (end <= calendar.span_.from) return Problem{"it ends before it begins"};
  calendar.span_.to = end;
  std::vector<Interval> duties;
  for (Interval duty : calendar.duties_) {
    duty.to = std::min(duty.to, end);
    if (duty.from < duty.to) duties.push_back(duty);
  }
  calendar.duties_ = std::move(duties);
  return calendar;
}

double Calendar::DutyLeft(Time now) const {
  for (const Interval& duty : duties_) {
    if (now >= duty.from && now < duty.to) return SecondsOf({now, duty.to});
  }
  return 0;
}

Time Calendar::NextChange(Time now) const {
  for (const Interval& duty : duties_) {
    if (now < duty.from) return duty.from;
    if (now < duty.to) return duty.to;
  }
  return kNever;
}

}  // namespace coppice::robot::deployment
