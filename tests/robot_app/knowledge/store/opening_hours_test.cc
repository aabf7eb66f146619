#include "robot_app/knowledge/store/opening_hours.h"

#include <gtest/gtest.h>

namespace coppice::robot::knowledge {
namespace {

// "11:00-14:30 17:00-19:00"; empty: closed.
std::string On(const std::string& hours, const std::string& day, bool is_holiday = false) {
  std::string text;
  for (const OpenSpan& span : OpeningHours::Parse(hours).value().On(*ParseDay(day), is_holiday)) {
    text += (text.empty() ? "" : " ") + ClockText(span.from) + "-" + ClockText(span.to);
  }
  return text;
}

TEST(OpeningHours, ARuleHoldsOnItsWeekdays) {
  EXPECT_EQ(On("Mo-Fr 08:00-16:00", "2026-11-27"), "08:00-16:00");
  EXPECT_EQ(On("Mo-Fr 08:00-16:00", "2026-11-28"), "");
  EXPECT_EQ(On("Sa-Mo 08:00-16:00", "2026-11-23"), "08:00-16:00");
  EXPECT_EQ(On("Mo,We 08:00-12:00", "2026-11-24"), "");
}

TEST(OpeningHours, ADayMayHaveSeveralTimes) {
  EXPECT_EQ(On("Mo-Th 11:00-14:30,17:00-19:00", "2026-11-25"), "11:00-14:30 17:00-19:00");
}

TEST(OpeningHours, TheLastRuleThatFitsHolds) {
  const std::string hours = "Mo-Su 08:00-20:00; Sa 10:00-14:00; PH off; Dec 24-Jan 01 off";
  EXPECT_EQ(On(hours, "2026-11-25"), "08:00-20:00");
  EXPECT_EQ(On(hours, "2026-11-28"), "10:00-14:00");
  EXPECT_EQ(On(hours, "2026-11-25", true), "");
  EXPECT_EQ(On(hours, "2026-12-30"), "");
  EXPECT_EQ(On(hours, "2027-01-01"), "");
  EXPECT_EQ(On(hours, "2027-01-02"), "10:00-14:00");
}

TEST(OpeningHours, APlaceMayCloseAfterMidnightOrNever) {
  const auto spans =
      OpeningHours::Parse("Fr 22:00-02:00").value().On(*ParseDay("2026-11-27"), false);
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_EQ(spans[0].to, std::chrono::hours(26));
  EXPECT_EQ(OpeningHours::Parse("24/7").value().On({0}, true)[0].to, std::chrono::hours(24));
}

// 2026-11-25 is a Wednesday.
double HoursOpen(const char* hours, const char* day, int hour) {
  const auto opening = OpeningHours::Parse(hours);
  const auto left = opening.value().OpenFor({*ParseDay(day), std::chrono::hours(hour)});
  return std::chrono::duration<double, std::ratio<3600>>(left).count();
}

TEST(OpeningHours, TellsHowLongItIsStillOpen) {
  EXPECT_EQ(HoursOpen("Mo-Fr 09:00-17:00", "2026-11-25", 10), 7);
  EXPECT_EQ(HoursOpen("Mo-Fr 09:00-17:00", "2026-11-25", 9), 8);
  EXPECT_EQ(HoursOpen("Mo-Fr 09:00-17:00", "2026-11-25", 17), 0) << "closed";
  EXPECT_EQ(HoursOpen("Mo-Fr 09:00-17:00", "2026-11-25", 8), 0) << "not yet open";
  EXPECT_EQ(HoursOpen("Mo-Fr 09:00-17:00", "2026-11-28", 10), 0) << "a Saturday";
}

TEST(OpeningHours, WhatIsOpenOverMidnightStaysOpen) {
  EXPECT_EQ(HoursOpen("Fr 22:00-02:00", "2026-11-28", 1), 1);
  EXPECT_EQ(HoursOpen("Mo-Fr 00:00-24:00", "2026-11-25", 12), 60) << "until Friday is over";
  EXPECT_EQ(HoursOpen("24/7", "2026-11-25", 12), 168) << "a week at most";
}

TEST(OpeningHours, WhatIsNoneIsSaid) {
  for (const char* wrong : {"", "Mo-Fr", "Mo-Fr 8-16", "Mx 08:00-16:00", "Mo-Fr 08:00-16:61",
                            "Mo-Fr 08:00-16:00;", "Feb 00 off", "sunrise-sunset", "Mo--Fr off"}) {
    EXPECT_FALSE(OpeningHours::Parse(wrong).ok()) << wrong;
  }
  EXPECT_EQ(OpeningHours::Parse("Mo 8-16").problem(),
            "\"Mo 8-16\" are no opening hours, such as \"Mo-Fr 08:00-16:00; PH off\"");
}

}  // namespace
}  // namespace coppice::robot::knowledge
