#include "robot_app/knowledge/store/site_time.h"

#include <gtest/gtest.h>

namespace coppice::robot::knowledge {
namespace {

using std::chrono::hours;
using std::chrono::minutes;
using std::chrono::seconds;

SiteTime Berlin() { return SiteTime::Find("Europe/Berlin").value(); }

// Seconds since 1970 in UTC.
WallTime Utc(std::int64_t count) { return WallTime(seconds(count)); }

TEST(SiteTime, ADayIsCountedFrom1970) {
  EXPECT_EQ(DayOf({1970, 1, 1})->number, 0);
  EXPECT_EQ(DayOf({2026, 11, 25})->number, 20782);
  EXPECT_EQ(IsoText({20782}), "2026-11-25");
  EXPECT_EQ(WeekdayOf({0}), 3);
}

TEST(SiteTime, OnlyDaysOfTheCalendarAreDays) {
  EXPECT_TRUE(ParseDay("2028-02-29"));
  EXPECT_TRUE(ParseDay("20280229"));
  for (const char* wrong :
       {"2026-02-29", "2026-13-01", "26-01-01", "2026/01/01", "", "2026-1-01"}) {
    EXPECT_FALSE(ParseDay(wrong)) << wrong;
  }
}

TEST(SiteTime, TheWallShowsSummerAndWinterTime) {
  const LocalTime winter = Berlin().Local(Utc(1795608000));  // 2026-11-25 12:00 UTC
  EXPECT_EQ(IsoText(winter.day), "2026-11-25");
  EXPECT_EQ(ClockText(winter.time), "13:00");
  EXPECT_EQ(ClockText(Berlin().Local(Utc(1782907200)).time), "14:00");  // 2026-07-01 12:00 UTC
}

TEST(SiteTime, ATimetableCountsFromNoonMinusTwelveHoursOnTheDayTheClocksChange) {
  const Day spring = *ParseDay("2027-03-28");
  const LocalTime morning = Berlin().Local(Berlin().OfTimetable(spring, hours(8)));
  EXPECT_EQ(morning.day, spring);
  EXPECT_EQ(ClockText(morning.time), "08:00");
  // One hour of that night is missing, so half past one is an hour earlier on the wall.
  EXPECT_EQ(ClockText(Berlin().Local(Berlin().OfTimetable(spring, minutes(90))).time), "00:30");
}

TEST(SiteTime, ATimetableGoesOnAfterMidnight) {
  const LocalTime night = Berlin().Local(Berlin().OfTimetable({20782}, hours(25)));
  EXPECT_EQ(IsoText(night.day), "2026-11-26");
  EXPECT_EQ(ClockText(night.time), "01:00");
}

TEST(SiteTime, AnUnknownZoneIsAProblem) {
  EXPECT_EQ(SiteTime::Find("Europe/Erlenhof").problem(),
            "\"Europe/Erlenhof\" is no time zone, such as Europe/Berlin");
}

}  // namespace
}  // namespace coppice::robot::knowledge
