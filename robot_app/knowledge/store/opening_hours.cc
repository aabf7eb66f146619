#include "robot_app/knowledge/store/opening_hours.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace coppice::robot::knowledge {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

constexpr std::array kWeekdays = {"Mo", "Tu", "We", "Th", "Fr", "Sa", "Su"};
constexpr std::array kMonths = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};

template <class Words>
std::optional<int> IndexOf(std::string_view word, const Words& words) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return std::nullopt;
  return static_cast<int>(found - words.begin());
}

std::vector<std::string_view> Split(std::string_view text, char by) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(by);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::string_view Trim(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

std::optional<minutes> ReadClock(std::string_view text) {
  if (text.size() != 5 || text[2] != ':' || !IsDigit(text[0]) || !IsDigit(text[1]) ||
      !IsDigit(text[3]) || !IsDigit(text[4])) {
    return std::nullopt;
  }
  const int hour = 10 * (text[0] - '0') + text[1] - '0';
  const int minute = 10 * (text[3] - '0') + text[4] - '0';
  if (hour > 48 || minute > 59) return std::nullopt;
  return hours(hour) + minutes(minute);
}

std::optional<OpenSpan> ReadSpan(std::string_view text) {
  const auto ends = Split(text, '-');
  if (ends.size() != 2) return std::nullopt;
  const auto from = ReadClock(Trim(ends[0])), to = ReadClock(Trim(ends[1]));
  if (!from || !to) return std::nullopt;
  return OpenSpan{*from, *to > *from ? *to : *to + hours(24)};
}

std::optional<std::vector<OpenSpan>> ReadSpans(std::string_view text) {
  std::vector<OpenSpan> spans;
  if (text == "off" || text == "closed") return spans;
  for (const std::string_view part : Split(text, ',')) {
    const auto span = ReadSpan(part);
    if (!span) return std::nullopt;
    spans.push_back(*span);
  }
  return spans;
}

// "Dec 24" as 1224.
std::optional<int> ReadDate(std::string_view text) {
  const auto words = Split(text, ' ');
  if (words.size() != 2) return std::nullopt;
  const auto month = IndexOf(words[0], kMonths);
  const std::string_view day = words[1];
  if (!month || day.empty() || day.size() > 2 || !std::all_of(day.begin(), day.end(), IsDigit)) {
    return std::nullopt;
  }
  const int number = std::stoi(std::string(day));
  if (number < 1 || number > 31) return std::nullopt;
  return 100 * (*month + 1) + number;
}

std::optional<std::pair<int, int>> ReadDates(std::string_view text) {
  const auto ends = Split(text, '-');
  const auto from = ReadDate(Trim(ends.front())), to = ReadDate(Trim(ends.back()));
  if (ends.size() > 2 || !from || !to) return std::nullopt;
  return std::pair(*from, *to);
}

// Where the times of a rule begin: at the first digit behind a space that a colon follows.
std::size_t BeginOfTimes(std::string_view rule) {
  for (const std::string_view word : {"off", "closed"}) {
    if (rule.size() >= word.size() && rule.substr(rule.size() - word.size()) == word) {
      return rule.size() - word.size();
    }
  }
  const std::size_t colon = rule.find(':');
  return colon == std::string_view::npos || colon < 2 ? std::string_view::npos : colon - 2;
}

}  // namespace

Expected<OpeningHours> OpeningHours::Parse(std::string_view text) {
  OpeningHours opening;
  for (const std::string_view part : Split(text, ';')) {
    auto rule = ParseRule(Trim(part));
    if (!rule) return Problem{rule.problem()};
    opening.rules_.push_back(*std::move(rule));
  }
  return opening;
}

Expected<OpeningHours::Rule> OpeningHours::ParseRule(std::string_view text) {
  const Problem problem{"\"" + std::string(text) +
                        "\" are no opening hours, such as \"Mo-Fr 08:00-16:00; PH off\""};
  Rule rule;
  if (text == "24/7") text = "00:00-24:00";
  const std::size_t begin = BeginOfTimes(text);
  if (begin == std::string_view::npos) return problem;
  const auto spans = ReadSpans(Trim(text.substr(begin)));
  if (!spans || !ReadDays(Trim(text.substr(0, begin)), rule)) return problem;
  rule.spans = *spans;
  return rule;
}

bool OpeningHours::ReadDays(std::string_view text, Rule& rule) {
  if (text.empty()) {
    std::fill(std::begin(rule.on_weekday), std::end(rule.on_weekday), true);
    return true;
  }
  for (std::string_view part : Split(text, ',')) {
    part = Trim(part);
    if (part == "PH") {
      rule.on_holidays = true;
      continue;
    }
    if (const auto dates = ReadDates(part)) {
      rule.dates.push_back(*dates);
      continue;
    }
    const auto ends = Split(part, '-');
    const auto first = IndexOf(ends.front(), kWeekdays), last = IndexOf(ends.back(), kWeekdays);
    if (ends.size() > 2 || !first || !last) return false;
    for (int day = *first;; day = (day + 1) % 7) {
      rule.on_weekday[day] = true;
      if (day == *last) break;
    }
  }
  return true;
}

bool OpeningHours::Rule::Fits(Day day, bool is_holiday) const {
  const CalendarDate date = DateOf(day);
  const int of_year = 100 * date.month + date.day;
  return on_weekday[WeekdayOf(day)] || (on_holidays && is_holiday) ||
         std::any_of(dates.begin(), dates.end(), [&](const auto& range) {
           return range.first <= range.second ? range.first <= of_year && of_year <= range.second
                                              : range.first <= of_year || of_year <= range.second;
         });
}

std::vector<OpenSpan> OpeningHours::On(Day day, bool is_holiday) const {
  std::vector<OpenSpan> spans;
  for (const Rule& rule : rules_) {
    if (rule.Fits(day, is_holiday)) spans = rule.spans;
  }
  return spans;
}

std::chrono::seconds OpeningHours::OpenFor(const LocalTime& now) const {
  constexpr std::chrono::hours kDay(24);
  std::chrono::seconds end = now.time;
  // The night before may last until now.
  for (int day = -1; day <= 7; ++day) {
    for (const OpenSpan& span : On(now.day + day, false)) {
      if (day * kDay + span.from <= end) end = std::max(end, day * kDay + span.to);
    }
  }
  return std::min<std::chrono::seconds>(end - now.time, 7 * kDay);
}

}  // namespace coppice::robot::knowledge
