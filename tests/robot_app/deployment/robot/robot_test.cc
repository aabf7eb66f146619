#include "robot_app/deployment/robot/robot.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "robot_app/deployment/figures/figures.h"
#include "robot_app/deployment/figures/journal_file.h"
#include "robot_app/deployment/run_seeds.h"
#include "tests/robot_app/deployment/made_journal.h"
#include "tests/support/folders.h"

namespace coppice::robot::deployment {
namespace {

// Deployments of two days, of which a few are enough to see every part of the robot at work.
class DeploymentTest : public testing::Test {
 protected:
  DeploymentTest() {
    Diagnostics diagnostics;
    const std::string folder = SourceFolder() + "/robot_app/deployment/";
    scenario_ = LoadScenario(folder + "scenario/scenario.yaml", diagnostics);
    controllers_ = LoadControllers(folder + "controllers.yaml", diagnostics);
    shipped_ = LoadShipped(SourceFolder(), diagnostics);
    EXPECT_EQ(diagnostics.ToString(), "");
    EXPECT_TRUE(Shorten(2, scenario_));
  }

  const Controller& Named(const std::string& name) const {
    return *std::find_if(controllers_.begin(), controllers_.end(),
                         [&](const Controller& c) { return c.name == name; });
  }
  Journal Live(std::uint64_t seed, const std::string& controller = "ours") const {
    Journal journal = RunSeed(scenario_, *shipped_, Named(controller), seed, "");
    journal.cpu_seconds = 0;
    return journal;
  }
  void OnlyFault(Fault fault, double rate) {
    scenario_.rates.fill(0);
    scenario_.rates[static_cast<std::size_t>(fault)] = rate;
  }

  Scenario scenario_;
  std::vector<Controller> controllers_;
  std::optional<Shipped> shipped_;
};

TEST_F(DeploymentTest, TheSameSeedGivesTheSameJournalToTheLastByteAndAnotherOneAnother) {
  const std::string first = ToText(Live(7));
  EXPECT_EQ(first, ToText(Live(7)));
  EXPECT_NE(first, ToText(Live(8)));
}

TEST_F(DeploymentTest, WithoutFaultsItPatrolsInOfficeHoursAndSpendsTheNightOnItsStation) {
  scenario_.rates.fill(0);
  const Journal journal = Live(1);
  EXPECT_THAT(journal.recoveries,
              testing::Each(testing::Field(&leaves::RecoveryEvent::recovery, testing::Eq("dock"))));
  EXPECT_TRUE(journal.requests.empty());
  EXPECT_TRUE(journal.stops.empty());
  const Figures figures = FiguresOf(journal);
  EXPECT_EQ(figures.working_days, 2);
  EXPECT_GT(figures.autonomy(), 60) << "of the two days the first begins at 13:00";
  double night = 0;
  for (const Span& span : journal.spans) {
    if (IsUndocked(span.activity)) continue;
    night += SecondsIn(span.when, {At("2021-03-02 17:15"), At("2021-03-03 09:00")});
  }
  EXPECT_NEAR(night, 15.75 * 3600, 1);
}

TEST_F(DeploymentTest, APassingPersonIsWaitedForAndATrapIsLeftBackwards) {
  OnlyFault(Fault::kBlockage, 2);  // few enough that no trap follows another at once
  scenario_.blockage_passing = 0.5;
  scenario_.blockage_trap = 0.5;
  const Journal journal = Live(3);
  const auto count = [&](const char* recovery) {
    return std::count_if(journal.recoveries.begin(), journal.recoveries.end(),
                         [&](const leaves::RecoveryEvent& event) {
                           return event.recovery == recovery &&
                                  event.phase == leaves::RecoveryPhase::kSucceeded;
                         });
  };
  EXPECT_GT(count("wait and retry"), 5);
  EXPECT_GT(count("move backwards"), 5);
  EXPECT_TRUE(journal.requests.empty()) << journal.requests.front().subject;
}

TEST_F(DeploymentTest, ItDoesNotMoveBackwardsBeforePeopleWhomItSees) {
  OnlyFault(Fault::kBlockage, 3);
  scenario_.blockage_passing = 1;
  scenario_.blockage_trap = 0;
  scenario_.people_noticed = 1;
  const Journal journal = Live(3);
  EXPECT_GT(journal.faults.size(), 10U);
  // Who comes within a minute and a metre of the one before counts as the same obstacle.
  std::map<std::string, int> begun;
  for (const leaves::RecoveryEvent& event : journal.recoveries) {
    if (event.phase == leaves::RecoveryPhase::kBegun) ++begun[event.recovery];
  }
  EXPECT_GT(begun["wait and retry"], 20);
  EXPECT_LE(begun["move backwards"], 1);
  EXPECT_EQ(begun.size(), 2U + begun.count("dock"));
}

TEST_F(DeploymentTest, BehindAClosedCorridorItGoesOnWhereItCan) {
  OnlyFault(Fault::kBlockage, 0.3);
  scenario_.blockage_passing = 0;
  scenario_.blockage_trap = 0;
  scenario_.closed_at_door = 0;
  scenario_.closed_lasts = 3600;
  const Journal journal = Live(3);
  EXPECT_FALSE(journal.faults.empty());
  EXPECT_TRUE(journal.stops.empty());
  EXPECT_GT(FiguresOf(journal).moving, 0.9 * FiguresOf(journal).undocked);
}

TEST_F(DeploymentTest, WhoMustTellThePositionIsAskedAndTheRobotGoesOn) {
  OnlyFault(Fault::kLocalization, 0.5);
  scenario_.lost_transient = scenario_.lost_inside = 0;
  const Journal journal = Live(4);
  ASSERT_FALSE(journal.requests.empty());
  EXPECT_EQ(journal.requests[0].subject, "localization");
  EXPECT_TRUE(journal.requests[0].is_fixed);
  EXPECT_TRUE(journal.stops.empty());
}

TEST_F(DeploymentTest, ACrashLoopEndsWithoutAPersonWhereThePublishedRobotNeedsOne) {
  OnlyFault(Fault::kCrashLoop, 20);
  const Journal ours = Live(5), published = Live(5, "published");
  EXPECT_TRUE(ours.stops.empty());
  ASSERT_FALSE(published.stops.empty());
  EXPECT_EQ(published.stops[0].cause, "crash_loop");
}

TEST_F(DeploymentTest, AMuteChargeSignalIsNoticedByTheWatchdogAndByNobodyInThePublishedRobot) {
  OnlyFault(Fault::kChargeSignal, 20);
  const Journal ours = Live(6), published = Live(6, "published");
  EXPECT_TRUE(ours.stops.empty());
  ASSERT_FALSE(published.stops.empty());
  EXPECT_EQ(published.stops[0].cause, "charge_signal");
}

TEST_F(DeploymentTest, AFailedDockingIsTriedAgainWhereThePublishedRobotSwitchesItselfOff) {
  OnlyFault(Fault::kDocking, 0.5);
  scenario_.docking_persistent = 0;
  const Journal ours = Live(7), published = Live(7, "published");
  EXPECT_TRUE(ours.stops.empty());
  EXPECT_TRUE(std::all_of(ours.dockings.begin(), ours.dockings.end(),
                          [](const Docking& docking) { return docking.has_current; }));
  ASSERT_FALSE(published.stops.empty());
  EXPECT_EQ(published.stops[0].cause, "docking");
}

TEST_F(DeploymentTest, AContactWithoutCurrentIsMadeAnewWhereThePublishedRobotStands) {
  OnlyFault(Fault::kNoCurrent, 0.9);
  scenario_.docking_persistent = 0;
  const Journal ours = Live(8), published = Live(8, "published");
  EXPECT_TRUE(ours.stops.empty());
  ASSERT_FALSE(published.stops.empty());
  EXPECT_EQ(published.stops[0].cause, "no_current");
}

}  // namespace
}  // namespace coppice::robot::deployment
