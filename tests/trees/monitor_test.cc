// The monitor tree: what is done about a fault, and which fault comes first.
#include <gtest/gtest.h>

#include "tests/trees/tree_scenario.h"

namespace coppice {
namespace {

using Names = std::vector<std::string>;

class MonitorTree : public testing::Test {
 protected:
  MonitorTree() {
    scenario_.Set("charging", false);
    scenario_.Set("docked", false);
    scenario_.Set("configuration", std::string("operating"));
    scenario_.Set("going_home", false);
    scenario_.Tick();  // says once that no charging is needed
    scenario_.robot.calls.clear();
  }

  // Reports and ticks every half second.
  void Live(double seconds, const std::vector<std::pair<std::string, std::string>>& errors) {
    for (; seconds > 0; seconds -= 0.5) {
      scenario_.Advance(0.5);
      scenario_.Set("battery",
                    leaves::BatteryReading{scenario_.now(), 25, -6, 0.8, leaves::kNotMeasured, {}});
      scenario_.Report(errors);
      scenario_.Tick();
    }
  }
  // What the robot was asked, but for the heartbeat of the watchdog's request.
  Names Calls() const {
    Names calls;
    for (const std::string& call : robot_.calls) {
      if (call.rfind("SetChargeRequested", 0) != 0) calls.push_back(call);
    }
    return calls;
  }
  void Report(const std::vector<std::pair<std::string, std::string>>& errors) {
    scenario_.Report(errors);
    scenario_.Tick();
  }

  TreeScenario scenario_{"monitor/monitor.xml"};
  leaves::FakeRobot& robot_ = scenario_.robot;
};

TEST_F(MonitorTree, DoesNothingWhenAllIsWell) {
  Report({});
  EXPECT_EQ(scenario_.Tick(), Status::kSuccess);
  EXPECT_EQ(Calls(), Names{});
}

TEST_F(MonitorTree, RestartsANodeThatDoesNotAnswer) {
  Report({{"node", "/navigation"}});
  EXPECT_TRUE(scenario_.Runs("restart_node"));
  EXPECT_EQ(scenario_.LastCall(), "RestartNode /navigation");
}

TEST_F(MonitorTree, RestartsTheNodeThatPublishesASilentTopic) {
  Report({{"topic", "/simulator"}});
  EXPECT_EQ(scenario_.LastCall(), "RestartNode /simulator");
}

TEST_F(MonitorTree, AsksAPersonAboutARecordThatStopsForWhichNoNodeIsBlamed) {
  leaves::Health health;
  health.stamp = scenario_.now();
  health.entries = {
      {"logger", "record", "", leaves::HealthLevel::kError, "nothing written for 61 s"}};
  scenario_.Set("monitoring", health);
  scenario_.Tick();
  EXPECT_EQ(scenario_.CallsBeginning("Ask loggers: "), 1);
  EXPECT_EQ(scenario_.CallsBeginning("RestartNode"), 0);
}

TEST_F(MonitorTree, IsDoneWithANodeWhenNobodyBlamesItAnyMore) {
  Report({{"node", "/navigation"}});
  scenario_.Answer(true);
  EXPECT_TRUE(scenario_.Runs("restart_node"));
  Report({});
  EXPECT_FALSE(scenario_.Runs("restart_node"));
  EXPECT_EQ(scenario_.CallsOf("RestartNode /navigation"), 1);
  ASSERT_EQ(robot_.events.size(), 2u);
  EXPECT_EQ(robot_.events.back().phase, leaves::RecoveryPhase::kSucceeded);
  EXPECT_EQ(robot_.events.back().subject, "/navigation");
}

TEST_F(MonitorTree, RestartsSeveralFaultyNodesAtOnce) {
  Report({{"node", "/a"}, {"node", "/b"}, {"topic", "/c"}});
  scenario_.Answer(true);
  scenario_.Answer(true);
  scenario_.Answer(true);
  EXPECT_EQ(Calls(), (Names{"RestartNode /a", "RestartNode /b", "RestartNode /c"}));
}

TEST_F(MonitorTree, ANodeThatWaitsForAPersonHidesNoOtherDeadNode) {
  Report({{"node", "/a"}});
  scenario_.Answer(false);
  EXPECT_EQ(scenario_.CallsBeginning("Ask nodes: "), 1);
  Live(5, {{"node", "/a"}, {"node", "/b"}});
  EXPECT_EQ(Calls().back(), "RestartNode /b");
  EXPECT_EQ(robot_.open_requests.count("nodes"), 1u) << "the request stays open meanwhile";
}

TEST_F(MonitorTree, ANodeThatWaitsForAPersonHidesNoFaultOfTheNavigation) {
  Report({{"node", "/a"}});
  scenario_.Answer(false);
  Live(2, {{"node", "/a"}, {"navigation", "path"}});
  EXPECT_TRUE(scenario_.Runs("wait_and_retry"));
  EXPECT_EQ(robot_.open_requests.count("nodes"), 1u);
}

TEST_F(MonitorTree, NamesAllNodesThatNeedAPersonInOneRequest) {
  Report({{"node", "/a"}, {"node", "/b"}});
  scenario_.Answer(false);
  scenario_.Answer(false);
  EXPECT_NE(scenario_.LastCall().find("/a, /b"), std::string::npos) << scenario_.LastCall();
}

TEST_F(MonitorTree, RestartsANodeAgainThatDoesNotComeUp) {
  Report({{"node", "/a"}});
  scenario_.Answer(true);
  Live(61, {{"node", "/a"}});
  EXPECT_EQ(scenario_.CallsOf("RestartNode /a"), 2);
}

TEST_F(MonitorTree, GivesADeadNodePriorityOverARunningRecoveryInTheSameTick) {
  Report({{"navigation", "path"}});
  ASSERT_TRUE(scenario_.Runs("wait_and_retry"));
  Report({{"navigation", "path"}, {"node", "/docking"}});
  EXPECT_EQ(scenario_.LastCall(), "RestartNode /docking");
  EXPECT_EQ(scenario_.StatusOf("wait_and_retry"), Status::kIdle);
  ASSERT_EQ(robot_.events.size(), 3u);
  EXPECT_EQ(robot_.events[1].subject, "/docking");
  EXPECT_EQ(robot_.events[2].subject, "navigation");
  EXPECT_EQ(robot_.events[2].phase, leaves::RecoveryPhase::kInterrupted);
  EXPECT_EQ(robot_.events[2].time, robot_.events[1].time);
}

TEST_F(MonitorTree, GivesTheNavigationPriorityOverTheLocalization) {
  Report({{"localization", "/localization"}});
  ASSERT_EQ(scenario_.LastCall(), "Rotate 6.2832 0.4");
  Report({{"localization", "/localization"}, {"navigation", "path"}});
  EXPECT_EQ(scenario_.LastCall(), "CancelMotion") << "nothing else moves yet";
  EXPECT_TRUE(scenario_.Runs("wait_and_retry"));
}

TEST_F(MonitorTree, ARequestForHelpHidesNoLesserFault) {
  Live(50, {{"navigation", "path"}});
  robot_.done.Send({false, "blocked"});
  Live(62, {{"navigation", "path"}});
  robot_.done.Send({false, "blocked"});
  Live(1, {{"navigation", "path"}});
  ASSERT_EQ(robot_.open_requests.count("navigation"), 1u);
  Live(10, {{"navigation", "path"}, {"localization", "/localization"}, {"cpu", "host"}});
  EXPECT_EQ(scenario_.CallsOf("Rotate 6.2832 0.4"), 1);
  robot_.done.Send({true, ""});
  EXPECT_EQ(scenario_.CallsBeginning("Ask navigation"), 1) << "asked once";
}

TEST_F(MonitorTree, WithdrawsARequestWhenItsFaultHasGone) {
  Live(25, {{"navigation", "path"}});
  robot_.done.Send({false, "blocked"});
  Live(62, {{"navigation", "path"}});
  robot_.done.Send({false, "blocked"});
  Live(1, {{"navigation", "path"}});
  ASSERT_EQ(robot_.open_requests.count("navigation"), 1u);
  Live(40, {});
  EXPECT_EQ(scenario_.CallsOf("Withdraw navigation"), 0) << "it may be tried again";
  Live(7, {});
  EXPECT_EQ(Calls().back(), "Withdraw navigation");
}

// Nobody could help, or nobody answered until the deadline: the same answer.
class AskingAgain : public MonitorTree, public testing::WithParamInterface<const char*> {
 protected:
  using Errors = std::vector<std::pair<std::string, std::string>>;

  // Lets every action of the robot fail, until there are so many questions.
  bool LiveUntilAsked(long times, double longest) {
    for (double left = longest; left > 0; left -= 0.5) {
      if (scenario_.CallsBeginning("Ask " + subject_) >= times) return true;
      Live(0.5, errors_);
      robot_.done.Send({false, "blocked"});
    }
    return false;
  }

  const std::string subject_ = GetParam();
  const std::string monitor_ = subject_ == "nodes"            ? "node"
                               : subject_ == "emergency stop" ? "emergency_stop"
                                                              : subject_;
  const Errors errors_ = {{monitor_, "/part"}};
};

TEST_P(AskingAgain, ComesTenMinutesAfterNobodyCouldHelpAsLongAsTheFaultLasts) {
  ASSERT_TRUE(LiveUntilAsked(1, 900));
  for (long times = 2; times < 5; ++times) {
    robot_.AnswerRequest(subject_, false);
    EXPECT_FALSE(LiveUntilAsked(times, 599)) << "not yet " << times;
    EXPECT_TRUE(LiveUntilAsked(times, 70)) << times;
  }
}

TEST_P(AskingAgain, ComesAlsoWhenTheAnswerCameBehindAMoreUrgentFault) {
  ASSERT_TRUE(LiveUntilAsked(1, 900));
  Errors both = errors_;
  both.emplace_back("node", "/docking");
  Live(10, both);
  robot_.AnswerRequest(subject_, false);
  Live(30, both);
  robot_.done.Send({true, ""});
  EXPECT_TRUE(LiveUntilAsked(2, 900));
}

TEST_P(AskingAgain, IsNotNeededWhenItIsFixed) {
  ASSERT_TRUE(LiveUntilAsked(1, 900));
  robot_.AnswerRequest(subject_, true);
  Live(1, errors_);
  Live(1800, {});
  EXPECT_EQ(scenario_.CallsBeginning("Ask " + subject_), 1);
}

INSTANTIATE_TEST_SUITE_P(Subjects, AskingAgain,
                         testing::Values("navigation", "localization", "emergency stop", "nodes",
                                         "charging"));

TEST_F(MonitorTree, KeepsARequestOpenBehindAMoreUrgentFault) {
  Live(25, {{"navigation", "path"}});
  robot_.done.Send({false, "blocked"});
  Live(62, {{"navigation", "path"}});
  robot_.done.Send({false, "blocked"});
  Live(1, {{"navigation", "path"}});
  Live(20, {{"navigation", "path"}, {"node", "/docking"}});
  EXPECT_EQ(scenario_.CallsOf("Withdraw navigation"), 0);
  Live(47, {{"node", "/docking"}});
  EXPECT_EQ(scenario_.CallsOf("Withdraw navigation"), 1);
}

TEST_F(MonitorTree, TellsOfWhatItCannotRepairOnceAndWhenItHasGone) {
  Live(60, {{"cpu", "host"}, {"clock", "base"}});
  EXPECT_EQ(Calls(), (Names{"Tell cpu host: broken", "Tell clock base: broken"}));
  Live(40, {});
  EXPECT_EQ(scenario_.CallsOf("Tell cpu host: has gone"), 1);
  EXPECT_EQ(scenario_.CallsOf("Tell clock base: has gone"), 1);
}

// The programs on the other computer are dead to this one as well; that they cannot be restarted
// turns out much later.
TEST_F(MonitorTree, TellsOfABrokenNetworkWhileItStillRestartsWhatIsBehindIt) {
  Live(6, {{"node", "/second_system_monitor"}, {"network", "host second"}});
  EXPECT_TRUE(scenario_.Runs("restart_node"));
  EXPECT_EQ(Calls(),
            (Names{"RestartNode /second_system_monitor", "Tell network host second: broken"}));
  Live(20, {{"node", "/second_system_monitor"}, {"cpu", "load"}});
  EXPECT_EQ(Calls().size(), 2u);  // other messages wait
}

TEST_F(MonitorTree, TellsOfMonitorsThatItDoesNotKnow) {
  Live(10, {{"humidity", "kitchen"}});
  EXPECT_EQ(Calls(), Names{"Tell humidity kitchen: broken"});
}

TEST_F(MonitorTree, AsksToReleaseTheEmergencyStopAndMovesNothingMeanwhile) {
  Live(60, {{"emergency_stop", "button"}, {"navigation", "path"}, {"localization", "/l"}});
  EXPECT_EQ(scenario_.CallsBeginning("Ask emergency stop"), 1);
  EXPECT_EQ(scenario_.CallsBeginning("Move"), 0);
  EXPECT_EQ(scenario_.CallsBeginning("Rotate"), 0);
  Live(1, {{"emergency_stop", "button"}, {"node", "/a"}});
  EXPECT_EQ(Calls().back(), "RestartNode /a");
}

TEST_F(MonitorTree, AsksAboutChargingOnlyWhenTheFaultLasts) {
  Live(290, {{"charging", "current"}});
  EXPECT_EQ(scenario_.CallsBeginning("Ask"), 0);
  Live(20, {{"charging", "current"}});
  EXPECT_EQ(scenario_.CallsBeginning("Ask charging"), 1);
}

TEST_F(MonitorTree, RepairsNothingWithoutReports) {
  scenario_.Tick();
  EXPECT_EQ(scenario_.StatusOf("handle_errors"), Status::kIdle);
  EXPECT_EQ(Calls(), Names{});
}

TEST_F(MonitorTree, RepairsNothingOnOldReports) {
  scenario_.Report({{"node", "/navigation"}});
  scenario_.Advance(60);
  scenario_.Tick();
  EXPECT_EQ(scenario_.CallsOf("RestartNode /navigation"), 0);
}

TEST_F(MonitorTree, RevivesTheAggregatorWhenReportsStopAndAsksAtLast) {
  Report({});
  const auto silence = [&](double seconds) {
    for (; seconds > 0; --seconds) {
      scenario_.Advance(1);
      scenario_.Tick();
    }
  };
  for (int i = 0; i < 3; ++i) {
    silence(35);
    ASSERT_EQ(scenario_.CallsOf("RestartNode /health_aggregator"), i + 1);
    scenario_.Answer(true);
  }
  silence(35);
  EXPECT_EQ(scenario_.CallsBeginning("Ask monitoring"), 1);
  Report({});
  EXPECT_EQ(scenario_.CallsOf("Withdraw monitoring"), 1);
}

TEST_F(MonitorTree, SwitchesToChargingOnlyWhenTheCurrentHasLasted) {
  scenario_.Set("charging", true);
  scenario_.Set("docked", true);
  Live(59, {});
  EXPECT_EQ(scenario_.CallsBeginning("SetConfiguration"), 0);
  Live(3, {});
  EXPECT_EQ(Calls().back(), "SetConfiguration charging");
}

TEST_F(MonitorTree, SwitchesBackToOperatingOffTheStation) {
  scenario_.Set("configuration", std::string("charging"));
  Live(4, {});
  EXPECT_EQ(scenario_.CallsBeginning("SetConfiguration operating"), 1);
}

TEST_F(MonitorTree, SwitchesBackToOperatingWhenTheCurrentStopsBeforeTheBatteryIsFull) {
  scenario_.Set("configuration", std::string("charging"));
  scenario_.Set("docked", true);
  scenario_.Set("battery_level", 0.6);
  Live(4, {});
  EXPECT_EQ(scenario_.CallsBeginning("SetConfiguration operating"), 1);
}

TEST_F(MonitorTree, StaysInChargingWithAFullBatteryOnTheStation) {
  scenario_.Set("configuration", std::string("charging"));
  scenario_.Set("docked", true);
  scenario_.Set("battery_level", 1.0);
  Live(600, {});
  EXPECT_EQ(scenario_.CallsBeginning("SetConfiguration"), 0);
}

TEST_F(MonitorTree, LeavesAConfigurationAloneThatWasSetByHand) {
  scenario_.Set("configuration", std::string("mapping"));
  scenario_.Set("manual", true);
  Live(60, {});
  EXPECT_EQ(scenario_.CallsBeginning("SetConfiguration"), 0);
}

TEST(MonitorTreeWithoutBattery, KeepsTheConfigurationAndWatchesTheRest) {
  TreeScenario scenario("monitor/monitor.xml");
  scenario.Set("configuration", std::string("charging"));
  scenario.Report({{"node", "/docking"}});
  scenario.Tick();
  EXPECT_EQ(scenario.CallsBeginning("SetConfiguration"), 0);
  EXPECT_EQ(scenario.CallsOf("RestartNode /docking"), 1);
}

}  // namespace
}  // namespace coppice
