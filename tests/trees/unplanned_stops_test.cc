// The four unplanned stops of the published deployment (Stuede et al., ECMR 2021, and its
// evaluation scripts), each as a scenario in simulated time: none of them may end in a robot that
// stands somewhere and asks nobody.
#include <gtest/gtest.h>

#include <functional>

#include "tests/trees/tree_scenario.h"

namespace coppice {
namespace {

using leaves::BatteryReading;
using leaves::kNotMeasured;

constexpr double kStep = 0.5;  // s

// The robot's answers to what a tree asks of it.
using Answers = std::function<bool(const std::string& call)>;

// Lets the robot carry out, after `delay` seconds, whatever it was asked last.
class Life {
 public:
  Life(TreeScenario& scenario, Answers answers)
      : scenario_(scenario), answers_(std::move(answers)) {}

  // `before_tick` says what is fed to the tree.
  void Run(double seconds, const std::function<void()>& before_tick) {
    for (; seconds > 0; seconds -= kStep) {
      scenario_.Advance(kStep);
      before_tick();
      AnswerNewCalls();
      status_ = scenario_.Tick();
    }
  }
  Status status() const { return status_; }

 private:
  void AnswerNewCalls() {
    const auto& calls = scenario_.robot.calls;
    for (; answered_ < calls.size(); ++answered_) {
      const std::string& call = calls[answered_];
      for (const char* action :
           {"NavigateTo", "Dock", "Undock", "PressOn", "Say", "Rotate", "Move", "RestartNode"}) {
        if (call.rfind(action, 0) != 0) continue;
        scenario_.robot.done.Send({answers_(call), "as the test says"});
      }
    }
  }

  TreeScenario& scenario_;
  Answers answers_;
  std::size_t answered_ = 0;
  Status status_ = Status::kIdle;
};

// 4 March: a docking attempt failed, and the answer was an emergency shutdown.
TEST(UnplannedStops, AFailedDockingIsTriedFromAllSidesThenAPersonIsAskedThenItIsTriedAgain) {
  TreeScenario scenario("application/patrol.xml");
  scenario.Set("rounds", -1);
  scenario.Set("stops", 4);
  scenario.Set("charging", false);
  scenario.Set("docked", false);
  scenario.Set("battery_level", 0.25);
  bool station_is_fixed = false;
  Life life(scenario, [&](const std::string& call) {
    if (call.rfind("PressOn", 0) == 0) return false;
    if (call.rfind("Dock", 0) != 0) return true;
    scenario.Set("charging", station_is_fixed);
    scenario.Set("docked", station_is_fixed);
    return station_is_fixed;
  });
  life.Run(120, [] {});
  EXPECT_GE(scenario.CallsBeginning("Dock "), 6);
  EXPECT_GE(scenario.CallsBeginning("Dock 0.0"), 2) << "from aside";
  ASSERT_EQ(scenario.robot.open_requests.count("docking"), 1u);
  EXPECT_EQ(life.status(), Status::kRunning) << "the application goes on";

  life.Run(1800, [] {});  // nobody is there
  EXPECT_EQ(life.status(), Status::kRunning);
  station_is_fixed = true;
  scenario.robot.AnswerRequest("docking", true);
  life.Run(60, [] {});
  EXPECT_EQ(scenario.LastCall(), "SetExpression SLEEP") << "on the station";
}

// 9 March: the signal to approach the charger was not sent; the application knew nothing.
TEST(UnplannedStops, WithoutAChargeSignalTheWatchdogTakesOverAfterAMinute) {
  TreeScenario scenario("monitor/monitor.xml");
  double level = 0.5;
  bool is_docked = false;
  const auto feed = [&] {
    level += is_docked ? 0.0001 : -0.0001;
    const double current = is_docked ? 12 : -15;
    scenario.Set(
        "battery",
        BatteryReading{
            scenario.now(), 23 + 2.4 * level + 0.02 * current, current, level, kNotMeasured, {}});
    scenario.Set("battery_level", level);
    scenario.Set("charging", is_docked);
    scenario.Set("docked", is_docked);
    scenario.Set("going_home", false);  // the application hears nothing
    scenario.Set("distance_to_station", 30.0);
    scenario.Report();
  };
  Life life(scenario, [&](const std::string& call) {
    if (call.rfind("Dock", 0) == 0) is_docked = true;
    return call.rfind("PressOn", 0) != 0;
  });
  const auto run_until = [&](const char* call, double longest) {
    double seconds = 0;
    for (; seconds < longest && scenario.CallsOf(call) == 0; seconds += kStep) {
      life.Run(kStep, feed);
    }
    return seconds;
  };
  run_until("SetChargeRequested true", 3600);
  ASSERT_EQ(scenario.CallsOf("SetChargeRequested true"), 1);
  EXPECT_GT(level * 75, 9) << "before the reserve is touched";
  const double patience = run_until("Suspend", 120);
  EXPECT_NEAR(patience, 60, 2);
  EXPECT_EQ(scenario.CallsBeginning("Tell battery"), 1);
  life.Run(10, feed);
  EXPECT_TRUE(is_docked);
  EXPECT_EQ(scenario.CallsOf("Resume"), 0) << "it charges first";
  run_until("Resume", 7200);
  EXPECT_GT(level, 0.35);
  const auto& calls = scenario.robot.calls;
  const auto last = std::find_if(calls.rbegin(), calls.rend(), [](const std::string& call) {
    return call.rfind("SetChargeRequested", 0) == 0;
  });
  EXPECT_EQ(*last, "SetChargeRequested false");
}

TEST(UnplannedStops, TheWatchdogLeavesAnApplicationAloneThatIsOnItsWay) {
  TreeScenario scenario("monitor/monitor.xml");
  const auto feed = [&] {
    scenario.Set("battery", BatteryReading{scenario.now(), 23.2, -15, 0.11, kNotMeasured, {}});
    scenario.Set("going_home", scenario.CallsOf("SetChargeRequested true") > 0);
    scenario.Report();
  };
  Life life(scenario, [](const std::string&) { return true; });
  life.Run(600, feed);
  EXPECT_GE(scenario.CallsOf("SetChargeRequested true"), 100) << "a state with a heartbeat";
  EXPECT_EQ(scenario.CallsOf("Suspend"), 0);
}

TEST(UnplannedStops, TheWatchdogWorksWithoutAnyHealthReport) {
  TreeScenario scenario("monitor/monitor.xml");
  Life life(scenario, [](const std::string& call) { return call.rfind("PressOn", 0) != 0; });
  life.Run(90, [&] {
    scenario.Set("battery", BatteryReading{scenario.now(), 23.1, -15, 0.05, kNotMeasured, {}});
    scenario.Set("going_home", false);
  });
  EXPECT_EQ(scenario.CallsOf("Suspend"), 1);
  EXPECT_GE(scenario.CallsBeginning("NavigateTo"), 1);
}

TEST(UnplannedStops, ARobotThatMayNotReachItsStationCallsForHelpAtOnce) {
  TreeScenario scenario("monitor/monitor.xml");
  Life life(scenario, [](const std::string&) { return false; });
  life.Run(90, [&] {
    scenario.Set("battery", BatteryReading{scenario.now(), 23.0, -15, 0.02, kNotMeasured, {}});
    scenario.Set("going_home", true);
    scenario.Report();
  });
  EXPECT_EQ(scenario.robot.open_requests.count("battery"), 1u);
}

// 11 March: the filter and the navigation crashed again and again, ten restarts in three minutes.
TEST(UnplannedStops, ACrashLoopIsBoundedAndEndsWithAPersonWhileOtherNodesAreStillRepaired) {
  TreeScenario scenario("monitor/monitor.xml");
  int restarts = 0;
  double up_since = -1;
  double time = 0;
  double asked_at = -1;
  // The process supervisor's answer: three restarts in a minute, then refused.
  Life life(scenario, [&](const std::string& call) {
    if (call != "RestartNode /ekf") return true;
    if (++restarts > 3) return false;
    up_since = time;
    return true;
  });
  const auto feed = [&](bool other_fault) {
    return [&, other_fault] {
      time += kStep;
      const bool ekf_is_dead = up_since < 0 || time - up_since > 10;
      std::vector<std::pair<std::string, std::string>> errors;
      if (ekf_is_dead) errors.push_back({"node", "/ekf"});
      if (other_fault) errors.push_back({"node", "/camera"});
      scenario.Set("battery", BatteryReading{scenario.now(), 25, -6, 0.9, kNotMeasured, {}});
      scenario.Report(errors);
      if (asked_at < 0 && scenario.CallsBeginning("Ask nodes") > 0) asked_at = time;
    };
  };
  life.Run(180, feed(false));
  EXPECT_GT(asked_at, 0);
  EXPECT_LT(asked_at, 60) << "a person is asked within a minute";
  EXPECT_LE(scenario.CallsOf("RestartNode /ekf"), 7) << "after that only one attempt a minute";
  EXPECT_EQ(scenario.robot.open_requests.count("nodes"), 1u);
  life.Run(5, feed(true));
  EXPECT_GE(scenario.CallsOf("RestartNode /camera"), 1);
}

// 12 March: docked, but not charging, and the robot believed that all was well.
TEST(UnplannedStops, DockedWithoutCurrentIsNoSuccessAndEndsWithAPerson) {
  TreeScenario scenario("application/patrol.xml");
  scenario.Set("rounds", -1);
  scenario.Set("stops", 4);
  scenario.Set("battery_level", 0.25);
  bool has_contact = false;
  // The docking server reports success only with current; it comes for a moment and is gone again.
  Life life(scenario, [&](const std::string& call) {
    if (call.rfind("Dock 0 1", 0) == 0 && !has_contact) return has_contact = true;
    return call.rfind("Dock", 0) != 0 && call.rfind("PressOn", 0) != 0;
  });
  int seconds_charging = 4;
  life.Run(200, [&] {
    if (has_contact && seconds_charging > 0) --seconds_charging;
    scenario.Set("charging", has_contact && seconds_charging > 0);
    scenario.Set("docked", has_contact && seconds_charging > 0);
  });
  EXPECT_GE(scenario.CallsOf("PressOn"), 2)
      << "before it drove there, and when the current stopped";
  EXPECT_GE(scenario.CallsBeginning("Dock "), 6);
  EXPECT_EQ(scenario.robot.open_requests.count("docking"), 1u);
  EXPECT_EQ(life.status(), Status::kRunning);
}

TEST(UnplannedStops, ACurrentThatDoesNotLastDoesNotSwitchTheNavigationOff) {
  TreeScenario scenario("monitor/monitor.xml");
  scenario.Set("configuration", std::string("operating"));
  Life life(scenario, [](const std::string&) { return true; });
  double time = 0;
  life.Run(600, [&] {
    time += kStep;
    const bool charging = static_cast<int>(time) % 50 < 40;  // breaks off again and again
    scenario.Set("charging", charging);
    scenario.Set("docked", charging);
    scenario.Set("battery",
                 BatteryReading{scenario.now(), 25, charging ? 12.0 : -6.0, 0.5, kNotMeasured, {}});
    scenario.Report();
  });
  EXPECT_EQ(scenario.CallsOf("SetConfiguration charging"), 0);
}

// The same day without luck: the station cannot be reached and nobody comes. The battery's end is
// announced, recorded, and in order.
TEST(UnplannedStops, ARobotThatNobodyHelpsSwitchesItselfOffBeforeItsBatteryDoes) {
  TreeScenario scenario("monitor/monitor.xml");
  double level = 0.1;
  double current = -15;
  const auto feed = [&] {
    level += current * kStep / 3600 / 75;
    scenario.Set(
        "battery",
        BatteryReading{
            scenario.now(), 23 + 2.4 * level + 0.02 * current, current, level, kNotMeasured, {}});
    scenario.Set("battery_level", level);
    scenario.Set("charging", current > 0);
    scenario.Set("docked", current > 0);
    scenario.Set("going_home", false);
    scenario.Set("distance_to_station", 30.0);
    scenario.Report();
  };
  Life life(scenario, [](const std::string& call) {  // all ways are blocked
    return call.rfind("NavigateTo", 0) != 0 && call.rfind("Dock", 0) != 0;
  });
  const auto run_until = [&](const std::string& call, double longest) {
    double seconds = 0;
    for (; seconds < longest && scenario.CallsBeginning(call) == 0; seconds += kStep) {
      life.Run(kStep, feed);
    }
    return seconds;
  };
  EXPECT_LT(run_until("Ask battery", 7200), 7200) << "first of all people are asked";
  EXPECT_GT(level * 75, 4);
  EXPECT_LT(run_until("Tell battery: My battery is empty", 7200), 7200);
  EXPECT_EQ(scenario.CallsBeginning("SwitchOff"), 0);
  EXPECT_TRUE(scenario.Runs("stands"));
  EXPECT_EQ(scenario.CallsOf("Suspend"), scenario.CallsOf("Resume") + 1) << "it stands";
  EXPECT_NEAR(run_until("SwitchOff", 7200), 180, 2);
  EXPECT_GT(level * 75, 0.5) << "there is enough left to end in order";
  EXPECT_EQ(scenario.robot.open_requests.count("battery"), 1u);

  scenario.robot.done.Send({true, "safe stop"});
  life.Run(600, feed);
  const auto& events = scenario.robot.events;
  EXPECT_EQ(std::count_if(events.begin(), events.end(),
                          [](const leaves::RecoveryEvent& event) {
                            return event.recovery == "switch off" &&
                                   event.phase == leaves::RecoveryPhase::kSucceeded;
                          }),
            1);
  EXPECT_EQ(scenario.CallsBeginning("SwitchOff"), 1);

  current = 12;  // somebody has charged it
  life.Run(5, feed);
  EXPECT_FALSE(scenario.Runs("stands"));
  EXPECT_EQ(scenario.CallsOf("Suspend"), scenario.CallsOf("Resume"));
}

}  // namespace
}  // namespace coppice
