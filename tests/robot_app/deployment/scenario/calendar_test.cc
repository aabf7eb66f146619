#include "robot_app/deployment/scenario/calendar.h"

#include <gtest/gtest.h>

#include "tests/robot_app/deployment/made_journal.h"

namespace coppice::robot::deployment {
namespace {

TEST(Calendar, APublishedDeploymentHasTwelveWorkingDaysTheFirstFromNoonOn) {
  const Journal journal = PublishedJournal();
  ASSERT_EQ(journal.duties.size(), 12u);
  EXPECT_EQ(SecondsOf(journal.duties.front()), 4 * 3600);
  EXPECT_EQ(MomentText(journal.duties[4].from), "2021-03-08 09:00:00") << "after the weekend";
  EXPECT_EQ(MomentText(journal.duties.back().to), "2021-03-17 17:00:00");
}

TEST(Calendar, TellsWhenADutyEndsAndTheNextOneBegins) {
  const auto calendar = Calendar::Make(PublishedJournal().span, "Mo-Fr 09:00-17:00").value();
  EXPECT_EQ(calendar.DutyLeft(At("2021-03-05 16:59:30")), 30);
  EXPECT_FALSE(calendar.OnDuty(At("2021-03-05 17:00")));
  EXPECT_EQ(calendar.NextChange(At("2021-03-05 17:00")), At("2021-03-08 09:00"));
  EXPECT_EQ(calendar.NextChange(At("2021-03-17 17:00")), kNever);
}

TEST(Calendar, AWeekendHas48Hours) {
  EXPECT_EQ(WeekendSeconds({At("2021-03-05 12:00"), At("2021-03-08 12:00")}), 48 * 3600);
  EXPECT_EQ(WeekendSeconds({At("2021-03-06 12:00"), At("2021-03-06 13:00")}), 3600);
  EXPECT_EQ(WeekendSeconds({At("2021-03-02 12:00"), At("2021-03-05 13:00")}), 0);
}

TEST(Calendar, WhatIsNoMomentIsAProblem) {
  for (const char* text : {"", "2021-03-02", "2021-02-30 10:00", "2021-03-02 25:00", "tomorrow"}) {
    EXPECT_FALSE(ParseMoment(text)) << text;
  }
}

TEST(Calendar, CanBeCutShort) {
  auto calendar = Calendar::Make(PublishedJournal().span, "Mo-Fr 09:00-17:00").value();
  calendar = Calendar::Cut(std::move(calendar), At("2021-03-03 12:00")).value();
  ASSERT_EQ(calendar.working_days(), 2);
  EXPECT_EQ(SecondsOf(calendar.duties().back()), 3 * 3600);
}

}  // namespace
}  // namespace coppice::robot::deployment
