#include "bt_core/analysis/play/scenario_of.h"

#include <gtest/gtest.h>

#include "bt_core/testing/scenario_writer.h"
#include "bt_core/testing/stand_in.h"
#include "tests/bt_core/analysis/recorded_run.h"

namespace coppice {
namespace {

using std::chrono::milliseconds;

// A leaf that drives for a while; each third drive fails.
class Drive final : public Action {
 public:
  static constexpr const char* kDescription = "Drives somewhere.";
  Input<std::string> to{this, "to", "where"};
  Output<double> left{this, "left", "metres to go"};
  Output<int> drives{this, "drives", "how many drives are done"};

  Status OnStart() override {
    remaining_ = 2.5;
    return OnRunning();
  }
  Status OnRunning() override {
    remaining_ -= 0.5;
    left.Set(remaining_);
    if (remaining_ > 0) return Status::kRunning;
    drives.Set(++count_);
    return count_ % 3 == 0 ? Status::kFailure : Status::kSuccess;
  }
  void OnHalted() override {}

 private:
  double remaining_ = 0;
  int count_ = 0;
};

std::shared_ptr<Registry> Nodes() {
  auto registry = std::make_shared<Registry>();
  registry->Register<Drive>("Drive");
  return registry;
}

// A patrol that recharges when the battery is low, and slows down when it comes near.
constexpr char kPatrol[] =
    "<BehaviorTree ID='Main'><ReactiveFallback name='top'>"
    "<Sequence name='recharge'><ScriptCondition name='low?' code='battery &lt; 20'/>"
    "<Drive name='to dock' to='dock' left='{left}' drives='{docked}'/></Sequence>"
    "<KeepRunningUntilFailure name='rounds'><Sequence name='round'>"
    "<Drive name='a' to='{goal}' left='{left}' drives='{drives}'/>"
    "<Script code='rounds += 1'/><Sleep msec='250'/>"
    "</Sequence></KeepRunningUntilFailure></ReactiveFallback></BehaviorTree>";

std::string WithStart(std::string tree) {
  return tree.replace(tree.find("name='top'"), 10, "name='top' _onSuccess='battery = 100'");
}

std::unique_ptr<RecordedRun> Patrol(int ticks) {
  auto run = std::make_unique<RecordedRun>(WithStart(kPatrol), Nodes());
  const Sender<double> battery = run->executor.Writer<double>("battery");
  const Sender<std::string> goal = run->executor.Writer<std::string>("goal");
  run->executor.Writer<std::int64_t>("rounds").Send(0);
  goal.Send("kitchen");
  for (int i = 0; i < ticks; ++i) {
    if (i % 10 == 0) battery.Send(100.0 - (i % 100));
    if (i == 30) goal.Send("hall");
    run->Tick();
  }
  return run;
}

std::shared_ptr<const Program> CompiledWithStandIns(const std::string& trees) {
  Diagnostics diagnostics;
  const auto project =
      Project::FromText("<root BTCPP_format='4' main_tree_to_execute='Main'>" + trees + "</root>",
                        "test.xml", diagnostics);
  return CompileText(trees, std::make_shared<Registry>(*ScenarioRegistry(*project)));
}

std::vector<Difference> Played(const std::string& trees, const Scenario& scenario) {
  return RunScenario(*CompiledWithStandIns(trees), {}, scenario).differences;
}

class ScenarioOfTest : public testing::Test {
 protected:
  std::optional<RecordedScenario> Make(const Recording& run, std::size_t first = 0,
                                       std::size_t end = SIZE_MAX) {
    Diagnostics diagnostics;
    auto made = ScenarioOf(run, first, end, "as recorded", diagnostics);
    problems_ = diagnostics.ToString();
    EXPECT_EQ(made.has_value(), !diagnostics.has_errors()) << problems_;
    return made;
  }
  std::string problems_;
};

TEST_F(ScenarioOfTest, ARunPassesAsAScenarioOfItsTree) {
  const auto run = Patrol(150);
  const auto made = Make(run->keeper.run);
  ASSERT_TRUE(made) << problems_;
  EXPECT_EQ(made->tree_id, "Main");
  EXPECT_EQ(made->first_tick, 0U);
  const auto differences = Played(WithStart(kPatrol), made->scenario);
  EXPECT_TRUE(differences.empty()) << differences[0].what << differences[0].got;
}

TEST_F(ScenarioOfTest, ItIsTheSameFromAFile) {
  const auto run = Patrol(150);
  const auto made = Make(run->keeper.run);
  ASSERT_TRUE(made) << problems_;
  ScenarioSuite suite;
  suite.file = "a.test.json";
  suite.tree_file = "a.xml";
  suite.scenarios = {made->scenario};
  Diagnostics diagnostics;
  const auto again = ParseScenarios(PrintScenarios(suite), "a.test.json", diagnostics);
  ASSERT_TRUE(again) << diagnostics.ToString();
  EXPECT_TRUE(Played(WithStart(kPatrol), again->scenarios[0]).empty());
}

TEST_F(ScenarioOfTest, AnotherTreeFailsAndSaysWhere) {
  const auto run = Patrol(150);
  const auto made = Make(run->keeper.run);
  ASSERT_TRUE(made) << problems_;
  std::string other = WithStart(kPatrol);
  other.replace(other.find("20"), 2, "5 ");
  const std::vector<Difference> differences = Played(other, made->scenario);
  ASSERT_FALSE(differences.empty());
  EXPECT_EQ(differences[0].expected, "tick to dock RUNNING");
  EXPECT_EQ(differences[0].step, 91U) << "when the battery was at 10";
}

TEST_F(ScenarioOfTest, APartBeginsWhereTheTreeWasBegun) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Drive name='a' to='x' left='{l}' drives='{d}'/></BehaviorTree>",
      Nodes());
  for (int i = 0; i < 20; ++i) run.Tick();  // a drive takes five ticks
  const auto made = Make(run.keeper.run, 8, 12);
  ASSERT_TRUE(made) << problems_;
  EXPECT_EQ(made->first_tick, 5U);
  EXPECT_EQ(made->scenario.steps.back().expect.status->status, Status::kRunning);
}

TEST_F(ScenarioOfTest, AHaltIsAStep) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Drive name='a' to='x' left='{l}' drives='{d}'/></BehaviorTree>",
      Nodes());
  run.Tick();
  run.Tick();
  run.executor.Halt();
  run.Tick();
  const auto made = Make(run.keeper.run);
  ASSERT_TRUE(made) << problems_;
  ASSERT_EQ(made->scenario.steps.size(), 4U);
  EXPECT_TRUE(made->scenario.steps[2].halt);
}

TEST_F(ScenarioOfTest, WhatIsNotKnownIsSaid) {
  auto run = Patrol(5);
  run->keeper.Lose();
  for (int i = 0; i < 5; ++i) run->Tick();
  EXPECT_FALSE(Make(run->keeper.run));
  EXPECT_NE(problems_.find("something is missing before tick 6"), std::string::npos) << problems_;
  EXPECT_FALSE(Make(run->keeper.run, 7));
  EXPECT_NE(problems_.find("begins with tick 6"), std::string::npos) << problems_;
  EXPECT_TRUE(Make(run->keeper.run, 0, 5)) << problems_;
  EXPECT_FALSE(Make(run->keeper.run, 9, 9));
  EXPECT_NE(problems_.find("no tick in this part"), std::string::npos) << problems_;
}

class Coin final : public UserControl {
 public:
  static constexpr const char* kDescription = "Succeeds every other time.";
  Status Tick(Children& children, bool) override {
    children.Tick(0);
    return ++count_ % 2 ? Status::kSuccess : Status::kFailure;
  }
  void OnHalted() override {}

 private:
  int count_ = 0;
};

TEST_F(ScenarioOfTest, WhatLeavesCannotReproduceIsSaid) {
  auto registry = Nodes();
  registry->Register<Coin>("Coin");
  RecordedRun run(
      "<BehaviorTree ID='Main'><Fallback><Coin name='coin'><AlwaysSuccess/></Coin>"
      "<AlwaysSuccess/></Fallback></BehaviorTree>",
      registry);
  for (int i = 0; i < 3; ++i) run.Tick();
  EXPECT_FALSE(Make(run.keeper.run));
  EXPECT_NE(problems_.find("tick 2: the tree does not do the same"), std::string::npos)
      << problems_;
}

}  // namespace
}  // namespace coppice
