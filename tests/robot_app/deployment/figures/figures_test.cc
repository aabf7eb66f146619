#include "robot_app/deployment/figures/figures.h"

#include <gmock/gmock.h>

#include "tests/robot_app/deployment/made_journal.h"

namespace coppice::robot::deployment {
namespace {

using leaves::RecoveryPhase;
using testing::DoubleNear;
using testing::ElementsAre;

TEST(Figures, TheLifetimesOfThePublishedInterventionsAreThePublishedOnes) {
  const Lifetimes lifetimes = LifetimesOf(PublishedJournal());
  EXPECT_THAT(lifetimes.hours,
              ElementsAre(DoubleNear(48.92, 0.01), DoubleNear(71.55, 0.01), DoubleNear(43.72, 0.01),
                          DoubleNear(28.73, 0.01), DoubleNear(90.60, 0.01)));
  EXPECT_NEAR(lifetimes.mean(), 56.7, 0.05);
  EXPECT_NEAR(lifetimes.most(), 90.6, 0.05);
}

TEST(Figures, WithoutAnInterventionTheLifetimeIsAllOfItButTheWeekends) {
  Journal journal = PublishedJournal();
  journal.stops.clear();
  EXPECT_THAT(LifetimesOf(journal).hours, ElementsAre(DoubleNear(283.52, 0.01)));
}

Journal OneDay() {
  Journal journal;
  journal.span = {At("2021-03-03 09:00"), At("2021-03-03 17:00")};
  journal.duties = {journal.span};
  const auto add = [&journal](const char* to, Activity activity) {
    const Time from = journal.spans.empty() ? journal.span.from : journal.spans.back().when.to;
    journal.spans.push_back({{from, At(std::string("2021-03-03 ") + to)}, activity});
  };
  add("12:00", Activity::kMoving);
  add("12:10", Activity::kRecovering);
  add("12:30", Activity::kAsking);
  add("14:30", Activity::kCharging);
  add("14:40", Activity::kNoCurrent);
  add("16:40", Activity::kMoving);
  add("17:00", Activity::kOff);
  return journal;
}

TEST(Figures, TimeInMotionIsOffTheStationWithoutErrorsAndRecoveries) {
  const Figures figures = FiguresOf(OneDay());
  EXPECT_NEAR(figures.moving, 5, 1e-9);
  EXPECT_NEAR(figures.undocked, 5.5, 1e-9);
  EXPECT_NEAR(figures.extra_charging, 2, 1e-9);
  EXPECT_NEAR(figures.autonomy(), 100 * 5 / 8.0, 1e-9);
}

TEST(Figures, AsTheScriptsCountOnlyGapsOf30To400SecondsAreNoMotion) {
  Journal journal = OneDay();
  const auto stand = [&journal](const char* from, const char* to) {
    journal.stands.push_back(
        {At(std::string("2021-03-03 ") + from), At(std::string("2021-03-03 ") + to)});
  };
  stand("10:00:00", "10:00:29");
  stand("10:10:00", "10:16:40");
  stand("12:00:00", "12:30:00");
  EXPECT_NEAR(FiguresOf(journal).moving_by_gaps, 5.5 - 400 / 3600.0, 1e-9);
}

// The fault that comes again after half a minute and half a metre.
TEST(Figures, RecoveriesAreCountedInBothReadingsOfSuccess) {
  Journal journal = OneDay();
  const auto recovery = [&journal](double second, double x, RecoveryPhase phase) {
    leaves::RecoveryEvent event;
    event.recovery = "wait and retry";
    event.subject = "navigation";
    event.phase = phase;
    event.time = journal.span.from + std::chrono::milliseconds(static_cast<int>(1000 * second));
    event.pose = leaves::Pose2D{x, 0, 0};
    journal.recoveries.push_back(event);
  };
  for (const auto& [second, x] : {std::pair(100.0, 5.0), {150.0, 5.5}, {500.0, 5.5}}) {
    recovery(second, x, RecoveryPhase::kBegun);
    recovery(second + 20, x, RecoveryPhase::kSucceeded);
  }
  const Figures figures = FiguresOf(journal);
  ASSERT_EQ(figures.recoveries.size(), 1u);
  EXPECT_EQ(figures.recoveries[0].count, 3);
  EXPECT_EQ(figures.recoveries[0].helped, 2);
  EXPECT_EQ(figures.recoveries[0].helped_strictly, 1) << "the third was at the same place";
}

TEST(Figures, DockingsCountByAttemptAndByVisit) {
  Journal journal = OneDay();
  journal.dockings = {{journal.span.from, 3, true, true, 200},
                      {journal.span.from, 1, true, false, 0}};
  const Figures figures = FiguresOf(journal);
  EXPECT_EQ(figures.dockings, 4);
  EXPECT_EQ(figures.good_dockings, 1);
  EXPECT_EQ(figures.docking_episodes, 2);
  EXPECT_EQ(figures.good_docking_episodes, 1);
}

TEST(Figures, RequestsCountApartFromInterventionsAndHaveATimeToTheAnswer) {
  Journal journal = OneDay();
  journal.requests = {
      {"navigation", journal.span.from, journal.span.from + std::chrono::minutes(6), true, ""},
      {"docking", journal.span.from, kNever, false, ""}};
  const Figures figures = FiguresOf(journal);
  EXPECT_EQ(figures.requests, 2);
  EXPECT_EQ(figures.answered, 1);
  EXPECT_NEAR(figures.answer_minutes, 6, 1e-9);
  EXPECT_EQ(figures.stops, 0);
}

}  // namespace
}  // namespace coppice::robot::deployment
