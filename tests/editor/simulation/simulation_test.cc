#include "editor/simulation/simulation.h"

#include <gtest/gtest.h>

#include <fstream>

#include "bt_core/analysis/load_recording.h"
#include "editor/timeline/run.h"
#include "tests/editor/simulation/simulated_text.h"

namespace coppice::editor {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr char kPatrol[] =
    R"(<ReactiveFallback name="top">)"
    R"(<Sequence name="low"><ScriptCondition code="battery &lt; 0.3"/><Dock name="dock"/>)"
    "</Sequence>"
    R"(<Sequence name="round"><Go name="go" to="{goal}"/><Say name="say"/></Sequence>)"
    "</ReactiveFallback>";
constexpr NodeIndex kDock{3}, kGo{5};

MockScript Returns(std::vector<Status> results) {
  MockScript script;
  script.results = std::move(results);
  return script;
}

class SimulationTest : public testing::Test {
 protected:
  Status StatusOf(NodeIndex node) const { return simulation_.state().status(node); }
  std::vector<Status> Statuses() const { return simulation_.state().statuses(); }
  void Start() {
    EXPECT_EQ(simulation_.SetKey("battery", "0.9").problem(), "");
    simulation_.Tick(Duration(0));
  }

  editor::Run run_;
  Simulation simulation_{CompiledRoot(kPatrol), run_};
};

TEST_F(SimulationTest, TicksWhenTimePassesAndTheRunShowsIt) {
  Start();
  EXPECT_EQ(StatusOf(kGo), Status::kRunning);
  simulation_.Tick(seconds(1));
  EXPECT_EQ(simulation_.now(), seconds(1));
  EXPECT_EQ(StatusOf(NodeIndex{6}), Status::kRunning) << "the next leaf begins";
  EXPECT_EQ(run_.size(), 2U);
  EXPECT_EQ(run_.now().statuses(), Statuses());
}

TEST_F(SimulationTest, AKeyTurnsTheTreeElsewhere) {
  Start();
  EXPECT_EQ(simulation_.ValueOf("battery"), "0.9");
  EXPECT_EQ(simulation_.SetKey("battery", "0.2").problem(), "");
  ASSERT_EQ(simulation_.waiting_keys().size(), 1U);
  simulation_.Tick(milliseconds(100));
  EXPECT_EQ(StatusOf(kDock), Status::kRunning);
  EXPECT_EQ(StatusOf(kGo), Status::kIdle);
  EXPECT_TRUE(simulation_.waiting_keys().empty());
}

TEST_F(SimulationTest, AKeyThatIsNotThereIsRefused) {
  EXPECT_EQ(simulation_.SetKey("batery", "1").problem(),
            R"(the tree has no key "batery", did you mean "battery"?)");
  EXPECT_EQ(simulation_.Keys(), (std::vector<std::string>{"goal", "battery"}));
}

TEST_F(SimulationTest, TheUserSaysWhatALeafReturns) {
  Start();
  EXPECT_EQ(simulation_.ScriptOf(kGo)->duration, seconds(1));
  EXPECT_TRUE(simulation_.SetScript(kGo, Returns({Status::kFailure})));
  EXPECT_EQ(simulation_.ScriptOf(kGo)->results[0], Status::kFailure);
  EXPECT_EQ(simulation_.Tick(Duration(0)), Status::kFailure);
  EXPECT_FALSE(simulation_.SetScript(NodeIndex{2}, Returns({}))) << "ScriptCondition plays itself";
}

TEST_F(SimulationTest, GoesBackToAnyTickAndOnFromThere) {
  Start();
  std::vector<std::vector<Status>> seen = {Statuses()};
  for (int i = 0; i < 30; ++i) {
    if (i == 12) {
      EXPECT_TRUE(simulation_.SetKey("battery", "0.1"));
    }
    if (i == 20) simulation_.SetScript(kDock, Returns({Status::kFailure}));
    simulation_.Tick(milliseconds(100));
    seen.push_back(Statuses());
  }
  for (const std::size_t tick : {25U, 3U, 13U, 30U, 0U}) {
    ASSERT_TRUE(simulation_.GoTo(tick));
    EXPECT_EQ(Statuses(), seen[tick]) << tick;
    EXPECT_EQ(simulation_.tick_of_run(), tick);
    EXPECT_EQ(run_.now().statuses(), seen[30]) << "its end is what happened last";
  }
  EXPECT_TRUE(simulation_.SetKey("battery", "0.1"));
  simulation_.Tick(milliseconds(100));
  EXPECT_EQ(StatusOf(kDock), Status::kRunning);
  EXPECT_EQ(run_.now().statuses(), Statuses());
  EXPECT_EQ(simulation_.now(), milliseconds(100));
  EXPECT_EQ(run_.size(), 32U) << "what was simulated before is still there";
  EXPECT_TRUE(simulation_.GoTo(30)) << "and one can go on from it";
  EXPECT_EQ(Statuses(), seen[30]);
  EXPECT_FALSE(simulation_.GoTo(32));
}

TEST_F(SimulationTest, TakesBackTickByTick) {
  Start();
  simulation_.Tick(seconds(1));
  EXPECT_TRUE(simulation_.Back());
  EXPECT_EQ(StatusOf(kGo), Status::kRunning);
  EXPECT_TRUE(simulation_.Back());
  EXPECT_EQ(StatusOf(kGo), Status::kIdle);
  EXPECT_EQ(simulation_.ticks(), 0U);
  EXPECT_TRUE(run_.is_at_beginning());
  EXPECT_FALSE(simulation_.Back());
}

TEST_F(SimulationTest, TheTickOfTheRunIsThatOfThisWayWhateverItsNumber) {
  for (int i = 0; i < 3; ++i) simulation_.Tick(milliseconds(100));
  simulation_.Restart();
  EXPECT_EQ(simulation_.tick_of_run(), std::nullopt);
  EXPECT_TRUE(run_.is_at_beginning());
  for (int i = 0; i < 3; ++i) simulation_.Tick(milliseconds(100));
  EXPECT_FALSE(run_.is_at_beginning());
  EXPECT_TRUE(simulation_.Back());
  EXPECT_EQ(simulation_.tick_of_run(), 4U) << "two runs of three ticks";
  ASSERT_TRUE(simulation_.GoTo(1));
  EXPECT_EQ(simulation_.ticks(), 2U);
  simulation_.GoToEnd();
  EXPECT_EQ(simulation_.tick_of_run(), 5U);
}

TEST_F(SimulationTest, TicksUntilSomethingChanges) {
  Start();
  simulation_.TickUntilChange(milliseconds(10), seconds(60));
  EXPECT_EQ(simulation_.now(), seconds(1));
  simulation_.SetScript(NodeIndex{6}, Returns({Status::kRunning}));
  simulation_.TickUntilChange(milliseconds(10), seconds(2));
  EXPECT_EQ(simulation_.now(), seconds(3)) << "nothing changes: the limit";
}

TEST_F(SimulationTest, AHaltEndsWhatRuns) {
  Start();
  simulation_.Halt();
  EXPECT_EQ(StatusOf(kGo), Status::kIdle);
  EXPECT_TRUE(simulation_.Back());
  EXPECT_EQ(StatusOf(kGo), Status::kRunning);
}

TEST_F(SimulationTest, AnEditIsReloadedAndWhatRunsGoesOn) {
  Start();
  simulation_.Tick(milliseconds(900));
  const std::string text = kPatrol;
  simulation_.Reload(CompiledRoot(text.substr(0, text.rfind("<Say")) +
                                  R"(<Wave name="say"/></Sequence>)"
                                  "</ReactiveFallback>"));
  EXPECT_EQ(StatusOf(kGo), Status::kRunning);
  simulation_.Tick(milliseconds(100));
  EXPECT_EQ(simulation_.program()->Id(NodeIndex{6}), "Wave");
  EXPECT_EQ(StatusOf(NodeIndex{6}), Status::kRunning) << "Go was done after its second";
  // Before the edit the tree was another; it is edited there as well.
  ASSERT_TRUE(simulation_.GoTo(0));
  EXPECT_EQ(simulation_.program()->Id(NodeIndex{6}), "Wave");
  EXPECT_EQ(StatusOf(kGo), Status::kRunning);
  EXPECT_EQ(run_.TracksAt(run_.size()).tree()->nodes[6].id, "Wave");
}

TEST_F(SimulationTest, TheSameIsDoneAgainWithTheTreeAsItIsNow) {
  Start();
  EXPECT_TRUE(simulation_.SetKey("battery", "0.25"));
  simulation_.Tick(milliseconds(100));
  EXPECT_EQ(StatusOf(kDock), Status::kRunning);
  std::string text = kPatrol;
  text.replace(text.find("0.3"), 3, "0.2");
  simulation_.Reload(CompiledRoot(text));
  simulation_.PlayAgain();
  EXPECT_EQ(simulation_.now(), milliseconds(100));
  EXPECT_EQ(StatusOf(kDock), Status::kIdle);
  EXPECT_EQ(StatusOf(kGo), Status::kRunning);
  simulation_.Restart();
  EXPECT_EQ(simulation_.ticks(), 0U);
}

TEST_F(SimulationTest, BecomesAScenarioThatPasses) {
  Start();
  simulation_.Tick(milliseconds(100));
  EXPECT_TRUE(simulation_.SetKey("battery", "0.2"));
  simulation_.SetScript(kDock, Returns({Status::kRunning, Status::kSuccess}));
  simulation_.Tick(milliseconds(100));
  simulation_.Tick(milliseconds(100));
  const Scenario scenario = simulation_.Record("docks");
  EXPECT_EQ(scenario.name, "docks");
  EXPECT_EQ(scenario.steps.back().expect.status->status, Status::kSuccess);
  ScenarioSuite suite;
  EXPECT_TRUE(RunScenario(*simulation_.program(), suite, scenario).differences.empty());
}

Chance OfTheFile(std::uint64_t seed) {
  Chance chance{seed, {}};
  chance.play.leaves = {{{}, {"<Do*>", Returns({Status::kSuccess})}},
                        {{}, {"<Elsewhere>", Returns({Status::kSuccess})}}};
  chance.play.set = {{{{"a.test.json", 1, 1}, "battery", "0.1", KeyValue::Kind::kNumber},
                      {{"a.test.json", 1, 1}, "battery", "0.2", KeyValue::Kind::kNumber}}};
  chance.play.lasts = seconds(2);
  return chance;
}

TEST_F(SimulationTest, ByChanceItIsATestThatPassesWithoutTheFile) {
  simulation_.SetChance(OfTheFile(4));
  for (int i = 0; i < 3; ++i) simulation_.Tick(milliseconds(100));
  EXPECT_EQ(simulation_.state().last(kDock), Status::kSuccess) << "the battery is low";
  const Scenario scenario = simulation_.Record("by chance");
  EXPECT_EQ(scenario.seed, 4U);
  ASSERT_EQ(scenario.steps[0].set.size(), 1U);
  EXPECT_EQ(scenario.steps[0].set[0].text, simulation_.ValueOf("battery"));
  const ScenarioResult again = RunScenario(*simulation_.program(), {}, scenario);
  EXPECT_TRUE(again.differences.empty()) << again.differences[0].what;
}

TEST_F(SimulationTest, WhatTheUserSetsComesBeforeWhatTheFileSets) {
  simulation_.SetChance(OfTheFile(4));
  EXPECT_EQ(simulation_.SetKey("battery", "0.9").problem(), "");
  simulation_.Tick(milliseconds(100));
  EXPECT_EQ(simulation_.ValueOf("battery"), "0.9");
  const Scenario scenario = simulation_.Record("full");
  ASSERT_EQ(scenario.steps[0].set.size(), 1U);
  EXPECT_EQ(scenario.steps[0].set[0].text, "0.9");
}

TEST_F(SimulationTest, WhatTheFileSetsWasNotToldByTheUser) {
  simulation_.SetChance(OfTheFile(4));
  simulation_.Tick(milliseconds(100));
  EXPECT_TRUE(simulation_.Told().set.empty()) << "the next run chooses for itself";
  EXPECT_TRUE(simulation_.Told().leaves.empty());
}

TEST_F(SimulationTest, ByChanceATreeIsBegunAnewForAsLongAsTheFileSays) {
  EXPECT_FALSE(simulation_.is_begun_anew());
  simulation_.SetChance(OfTheFile(4));
  EXPECT_TRUE(simulation_.is_begun_anew());
  simulation_.Tick(milliseconds(1900));
  EXPECT_TRUE(simulation_.is_begun_anew());
  simulation_.Tick(milliseconds(100));
  EXPECT_FALSE(simulation_.is_begun_anew());
}

TEST_F(SimulationTest, GoingBackKeepsTheChance) {
  simulation_.SetChance(OfTheFile(4));
  for (int i = 0; i < 3; ++i) simulation_.Tick(milliseconds(100));
  const std::string battery = simulation_.ValueOf("battery");
  EXPECT_TRUE(simulation_.Back());
  EXPECT_EQ(simulation_.chance()->seed, 4U);
  EXPECT_EQ(simulation_.ValueOf("battery"), battery);
  simulation_.Restart();
  EXPECT_EQ(simulation_.ticks(), 0U);
  simulation_.Tick(milliseconds(100));
  EXPECT_EQ(simulation_.ValueOf("battery"), battery);
}

TEST_F(SimulationTest, BecomesARecord) {
  Start();
  simulation_.Tick(seconds(1));
  const std::string path = testing::TempDir() + "simulated.coppice";
  std::ofstream(path, std::ios::binary) << simulation_.ToRecord();
  Diagnostics diagnostics;
  const auto record = LoadRecording(path, diagnostics);
  ASSERT_TRUE(record) << diagnostics.ToString();
  EXPECT_EQ(record->ticks().size(), 2U);
  EXPECT_EQ(record->trees()[0].info.metadata[0].second, "simulation");
}

}  // namespace
}  // namespace coppice::editor
