// When a place is open, in the notation of OpenStreetMap (wiki.openstreetmap.org, "Key:
// opening_hours"), of which this much is understood:
//
//   Mo-Fr 08:00-20:00; Sa,Su 10:00-14:00; PH off; Dec 24-Jan 01 off
//   Mo-Th 11:00-14:30,17:00-19:00; Fr 22:00-02:00
//   24/7
//
// Rules are separated by semicolons; the last one that fits a day holds for it. PH is a public
// holiday. A time before the one at which it opens is of the next day.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_STORE_OPENING_HOURS_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_STORE_OPENING_HOURS_H_

#include <chrono>
#include <string_view>
#include <utility>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/knowledge/store/site_time.h"

namespace coppice::robot::knowledge {

/// From when to when, since midnight; the end may lie in the next day.
struct OpenSpan {
  std::chrono::seconds from{0}, to{0};
};

class OpeningHours {
 public:
  static Expected<OpeningHours> Parse(std::string_view text);

  /// Empty: closed.
  std::vector<OpenSpan> On(Day day, bool is_holiday) const;

  /// Until it closes [s]; 0: it is closed. What opens when the other closes goes on; a week at
  /// most. No day counts as a holiday.
  std::chrono::seconds OpenFor(const LocalTime& now) const;

 private:
  struct Rule {
    bool on_weekday[7] = {};
    bool on_holidays = false;
    std::vector<std::pair<int, int>> dates;  // 100 * month + day, both included
    std::vector<OpenSpan> spans;

    bool Fits(Day day, bool is_holiday) const;
  };
  static Expected<Rule> ParseRule(std::string_view text);
  static bool ReadDays(std::string_view text, Rule& rule);

  std::vector<Rule> rules_;
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_STORE_OPENING_HOURS_H_
