#include "bt_core/testing/random_runs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/bt_core/testing/with_stand_ins.h"

namespace coppice {
namespace {

std::shared_ptr<const Program> Compiled(const std::string& root, const std::string& more = {}) {
  Diagnostics diagnostics;
  auto program =
      CompileWithStandIns("<root BTCPP_format=\"4\"" + more + "><BehaviorTree ID=\"Main\">" + root +
                              "</BehaviorTree></root>",
                          diagnostics);
  if (!program) throw std::invalid_argument(diagnostics.ToString());
  return program;
}

PlacedRule ByChance(const std::string& pattern, Chances chances) {
  PlacedRule rule;
  rule.rule.pattern = pattern;
  rule.rule.script.chances = chances;
  return rule;
}

Coverage After(int runs, RandomRuns random) {
  for (int i = 0; i < runs; ++i) random.Run();
  return random.coverage();
}

constexpr char kTree[] =
    R"(<Fallback><Sequence><IsDay/><Go name="go"/></Sequence><Sleep name="rest" msec="50"/>)"
    R"(<Call name="call"/></Fallback>)";

TEST(RandomRuns, CountsWhatEveryNodeDid) {
  const Coverage coverage = After(1000, RandomRuns(Compiled(kTree), {}));
  EXPECT_EQ(coverage.runs, 1000U);
  EXPECT_EQ(coverage.results[static_cast<std::size_t>(Status::kSuccess)], 1000U);
  ASSERT_EQ(coverage.nodes.size(), 6U);
  EXPECT_EQ(coverage.nodes[0].ticks(), coverage.ticks);
  EXPECT_NEAR(static_cast<double>(coverage.nodes[2].results_of(Status::kSuccess)), 500, 100);
  EXPECT_NEAR(static_cast<double>(coverage.nodes[3].results_of(Status::kFailure)), 100, 40);
  EXPECT_GT(coverage.nodes[3].results_of(Status::kRunning), 2000U) << "a second in the mean";
  EXPECT_EQ(NeverTicked(coverage), std::vector<std::string>{"call"}) << "resting never fails";
  const std::vector<std::string> never_failed = NeverReturned(coverage, Status::kFailure);
  EXPECT_NE(std::find(never_failed.begin(), never_failed.end(), "rest"), never_failed.end());
  EXPECT_EQ(std::find(never_failed.begin(), never_failed.end(), "go"), never_failed.end());
  EXPECT_TRUE(coverage.findings.empty());
}

TEST(RandomRuns, ARunCanBeHadAgainBySeed) {
  RandomRunOptions options;
  options.seed = 40;
  const Coverage all = After(5, RandomRuns(Compiled(kTree), options));
  Coverage sum;
  for (int i = 0; i < 5; ++i) {
    options.seed = 40 + static_cast<std::uint64_t>(i);
    sum.ticks += After(1, RandomRuns(Compiled(kTree), options)).ticks;
  }
  EXPECT_EQ(sum.ticks, all.ticks);
}

TEST(RandomRuns, RulesComeBeforeTheDefaults) {
  RandomRunOptions options;
  options.play.leaves = {ByChance("go", {0, 1, 0, Duration(0), Duration(0)})};
  const Coverage coverage = After(50, RandomRuns(Compiled(kTree), options));
  EXPECT_EQ(coverage.nodes[3].results_of(Status::kSuccess), 0U);
  EXPECT_GT(coverage.nodes[3].results_of(Status::kFailure), 0U);
}

TEST(RandomRuns, LeavesWriteTheirOutputs) {
  const char* const root =
      R"(<Sequence><Count n="{n}"/><ScriptCondition name="two?" code="n == 2"/></Sequence>)"
      R"(</BehaviorTree><TreeNodesModel><Action ID="Count"><output_port name="n" type="int"/>)"
      R"(</Action></TreeNodesModel><BehaviorTree ID="Other"><AlwaysSuccess/>)";
  const Coverage coverage =
      After(100, RandomRuns(Compiled(root, R"( main_tree_to_execute="Main")"), {}));
  EXPECT_TRUE(coverage.findings.empty()) << "n is written";
  EXPECT_GT(coverage.nodes[2].results_of(Status::kSuccess), 10U);
  EXPECT_GT(coverage.nodes[2].results_of(Status::kFailure), 10U);
}

TEST(RandomRuns, KeysGetOneOfTheirValues) {
  const char* const root =
      R"(<Repeat num_cycles="{stops}"><Script name="stop" code="n := 1"/></Repeat>)";
  RandomRunOptions options;
  options.play.set = {
      {{{}, "stops", "1", KeyValue::Kind::kNumber}, {{}, "stops", "3", KeyValue::Kind::kNumber}}};
  const Coverage some = After(100, RandomRuns(Compiled(root), options));
  EXPECT_GT(some.nodes[1].ticks(), 120U);
  EXPECT_LT(some.nodes[1].ticks(), 280U);
  options.set = {{{}, "stops", "2", KeyValue::Kind::kNumber}};
  EXPECT_EQ(After(100, RandomRuns(Compiled(root), options)).nodes[1].ticks(), 200U)
      << "what is set is more important";
}

TEST(RandomRuns, WhatOneRunGetsCanBeAsked) {
  const KeyValue one{{}, "stops", "1", KeyValue::Kind::kNumber};
  const KeyValue two{{}, "stops", "2", KeyValue::Kind::kNumber};
  const KeyValue lab{{}, "place", "lab", KeyValue::Kind::kString};
  std::string texts;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::vector<KeyValue> chosen = ChosenKeys({{one, two}, {lab}}, seed);
    ASSERT_EQ(chosen.size(), 2U);
    EXPECT_EQ(chosen[0].text, ChosenKeys({{lab}, {one, two}}, seed)[1].text) << "by key";
    EXPECT_EQ(chosen[1].text, "lab");
    texts += chosen[0].text;
  }
  EXPECT_NE(texts.find('1'), std::string::npos);
  EXPECT_NE(texts.find('2'), std::string::npos);
}

TEST(RandomRuns, WhatANodeIsToldIsMoreImportantThanAnyRule) {
  RandomRunOptions options;
  options.play.leaves = {ByChance("/go", {0, 1})};
  MockScript succeeds;
  succeeds.results = {Status::kSuccess};
  options.scripts = {{{}, {"go", succeeds}}};
  const Coverage coverage =
      After(20, RandomRuns(Compiled(R"(<Fallback><Go name="go"/><Call/></Fallback>)"), options));
  EXPECT_EQ(coverage.nodes[1].results_of(Status::kSuccess), 20U) << "a path comes before a name";
}

TEST(RandomRuns, ATreeThatIsDoneIsBegunAnewUntilTheTimeHasPassed) {
  RandomRunOptions options;
  options.play.lasts = std::chrono::seconds(10);
  const Coverage coverage = After(3, RandomRuns(Compiled("<AlwaysSuccess/>"), options));
  EXPECT_EQ(coverage.runs, 3U);
  EXPECT_EQ(coverage.ticks, 300U);
}

TEST(RandomRuns, AConditionStaysWhatItIsForSomeTime) {
  RandomRunOptions options;
  options.play.lasts = std::chrono::seconds(100);
  const Coverage coverage =
      After(1, RandomRuns(Compiled("<Fallback><IsDay/><Call name=\"call\"/></Fallback>"), options));
  EXPECT_LT(coverage.nodes[2].results_of(Status::kIdle), 60U)
      << "halted about every five seconds, not every time";
}

TEST(RandomRuns, ARuleForManyTypesComesBeforeTheDefaultOfOne) {
  RandomRunOptions options;
  options.play.leaves = {ByChance("<Is*>", {0, 1})};
  const Coverage coverage = After(50, RandomRuns(Compiled(kTree), options));
  EXPECT_EQ(coverage.nodes[2].results_of(Status::kSuccess), 0U);
  EXPECT_EQ(coverage.nodes[2].results_of(Status::kFailure), 50U);
}

TEST(RandomRuns, AnExceptionIsFoundWithTheRunThatHadIt) {
  const char* const root =
      R"(<Fallback><IsDay/><ScriptCondition name="low?" code="battery &lt; 0.3"/></Fallback>)";
  RandomRunOptions options;
  options.seed = 100;
  const Coverage coverage = After(50, RandomRuns(Compiled(root), options));
  ASSERT_EQ(coverage.findings.size(), 1U);
  const RandomFinding& found = coverage.findings[0];
  EXPECT_EQ(found.node, "low?");
  EXPECT_NE(found.text.find("battery"), std::string::npos) << found.text;
  EXPECT_NEAR(static_cast<double>(found.times), 25, 15);
  options.seed = found.seed;
  EXPECT_EQ(After(1, RandomRuns(Compiled(root), options)).findings.size(), 1U);

  options.set = {{{}, "battery", "0.5", KeyValue::Kind::kNumber}};
  EXPECT_TRUE(After(50, RandomRuns(Compiled(root), options)).findings.empty());
}

TEST(RandomRuns, ATreeThatTakesAllOfAProcessorIsFoundAndBrokenOff) {
  RandomRunOptions options;
  options.most_ticks = 3000;
  const Coverage coverage = After(
      2, RandomRuns(Compiled(R"(<Repeat num_cycles="-1"><AlwaysSuccess/></Repeat>)"), options));
  ASSERT_EQ(coverage.findings.size(), 1U);
  EXPECT_EQ(coverage.findings[0].times, 2U);
  EXPECT_EQ(coverage.ticks, 6000U);
  EXPECT_EQ(coverage.results[static_cast<std::size_t>(Status::kRunning)], 2U);
}

}  // namespace
}  // namespace coppice
