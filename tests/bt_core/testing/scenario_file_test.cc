#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "bt_core/testing/scenario.h"

namespace coppice {
namespace {

class ScenarioFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::path(testing::TempDir()) / (std::string(test->name()) + ".test.json");
  }
  void TearDown() override { std::filesystem::remove(path_); }

  std::optional<ScenarioSuite> Load(const std::string& text) {
    std::ofstream(path_) << text;
    Diagnostics diagnostics;
    auto suite = LoadScenarios(path_.string(), diagnostics);
    EXPECT_EQ(suite.has_value(), !diagnostics.has_errors());
    errors_ = diagnostics.ToString();
    return suite;
  }
  // The errors of a scenario with one step, without the name of the file.
  std::string StepErrors(const std::string& step) {
    Load(R"({"tree": "a.xml", "scenarios": [{"name": "s", "steps": [)" + step + "]}]}");
    return errors_.empty() ? "" : errors_.substr(errors_.find(": error: ") + 9);
  }

  std::filesystem::path path_;
  std::string errors_;
};

TEST_F(ScenarioFile, HoldsAllThatAScenarioCanSay) {
  const auto suite = Load(R"({
    // the tree lies beside the file
    "tree": "../trees/patrol.xml", "tree_id": "Patrol",
    "models": "../trees/models.xml",
    "leaves": {"<DriveTo>": ["RUNNING", "SUCCESS"]},
    "random": {"set": {"stops": [1, 2], "place": "lab"}, "leaves": {"<DriveTo>": "FAILURE"},
               "lasts_ms": 500},
    "scenarios": [{
      "name": "drives",
      "leaves": {"ask": {"returns": "FAILURE", "after_ms": 1.5, "restart": true,
                         "outputs": {"answer": 5}, "says": "no", "throws": "x"}},
      "steps": [
        {"set": {"battery": 0.5, "word": "hello", "on": true}, "advance_ms": 20, "ticks": 3,
         "leaves": {"ask": "SUCCESS"},
         "expect": {"status": "RUNNING", "nodes": {"a/b": "IDLE"},
                    "events": [["tick", "ask", "RUNNING", {"who": "me"}], ["halt", "x/y"]],
                    "blackboard": {"answer": 5, "other": null}, "messages": ["no"]}},
        {"halt": true}
      ]}]})");
  ASSERT_TRUE(suite) << errors_;
  EXPECT_EQ(suite->tree_file,
            (path_.parent_path() / "../trees/patrol.xml").lexically_normal().string());
  EXPECT_EQ(suite->tree_id, "Patrol");
  EXPECT_EQ(suite->models_file,
            (path_.parent_path() / "../trees/models.xml").lexically_normal().string());
  EXPECT_EQ(suite->leaves[0].rule.pattern, "<DriveTo>");
  EXPECT_EQ(suite->leaves[0].rule.script.results,
            (std::vector<Status>{Status::kRunning, Status::kSuccess}));
  ASSERT_TRUE(suite->random);
  ASSERT_EQ(suite->random->set.size(), 2U);
  ASSERT_EQ(suite->random->set[0].size(), 2U);
  EXPECT_EQ(suite->random->set[0][1].key + suite->random->set[0][1].text, "stops2");
  EXPECT_EQ(suite->random->set[1].at(0).text, "lab");
  EXPECT_EQ(suite->random->leaves.at(0).rule.pattern, "<DriveTo>");
  EXPECT_EQ(suite->random->lasts, std::chrono::milliseconds(500));
  const Scenario& scenario = suite->scenarios.at(0);
  EXPECT_EQ(scenario.name, "drives");
  const MockScript& ask = scenario.leaves[0].rule.script;
  EXPECT_EQ(ask.results, std::vector<Status>{Status::kFailure});
  EXPECT_EQ(ask.duration, std::chrono::microseconds(1500));
  EXPECT_TRUE(ask.restart);
  EXPECT_EQ(ask.outputs[0], (std::pair<std::string, std::string>("answer", "5")));
  EXPECT_EQ(ask.says + ask.throws, "nox");
  const ScenarioStep& step = scenario.steps.at(0);
  ASSERT_EQ(step.set.size(), 3U);
  EXPECT_EQ(step.set[0].kind, KeyValue::Kind::kNumber);
  EXPECT_EQ(step.set[0].text, "0.5");
  EXPECT_EQ(step.set[1].kind, KeyValue::Kind::kString);
  EXPECT_EQ(step.set[2].kind, KeyValue::Kind::kBool);
  EXPECT_EQ(step.advance, std::chrono::milliseconds(20));
  EXPECT_EQ(step.ticks, 3);
  EXPECT_EQ(step.leaves[0].rule.pattern, "ask");
  EXPECT_EQ(step.expect.status->status, Status::kRunning);
  EXPECT_EQ(step.expect.nodes[0].node, "a/b");
  ASSERT_EQ(step.expect.events->events.size(), 2U);
  EXPECT_EQ(step.expect.events->events[0].inputs[0].key, "who");
  EXPECT_TRUE(step.expect.events->events[1].halted);
  EXPECT_FALSE(step.expect.blackboard[0].unset);
  EXPECT_TRUE(step.expect.blackboard[1].unset);
  EXPECT_EQ(step.expect.messages[0].part, "no");
  EXPECT_TRUE(scenario.steps.at(1).halt);
}

TEST_F(ScenarioFile, AFileThatIsNotThereIsAnError) {
  Diagnostics diagnostics;
  EXPECT_FALSE(LoadScenarios("/none.test.json", diagnostics));
  EXPECT_EQ(diagnostics.ToString(),
            "/none.test.json: error: cannot be read: No such file or directory\n");
}

TEST_F(ScenarioFile, AllErrorsAreTold) {
  Load("{\n\"trees\": 5,\n\"scenarios\": [{\"steps\": 7}]\n}");
  const std::string file = path_.string();
  EXPECT_EQ(errors_, file +
                         R"(:2:10: error: unknown member "trees", expected tree, tree_id, models, )"
                         "leaves, random, scenarios (did you mean \"tree\"?)\n" +
                         file + ":3:25: error: \"steps\" must be a list, not a number\n" + file +
                         ":3:15: error: \"name\" is missing\n" + file +
                         ":3:15: error: there are no \"steps\"\n" + file +
                         ":1:1: error: \"tree\" is missing\n");
}

TEST_F(ScenarioFile, WhatIsNoScenarioIsRefused) {
  for (const char* text :
       {"", "5", "[]", "{}", R"({"tree": "a.xml"})", R"({"tree": "a.xml", "scenarios": []})",
        R"({"tree": 5})", R"({"tree": "a.xml", "scenarios": [5]})",
        R"({"tree": "a.xml", "scenarios": [{"name": "a"}]})"}) {
    EXPECT_FALSE(Load(text)) << text;
    EXPECT_EQ(errors_.rfind(path_.string() + ":1:", 0), 0U) << errors_;
  }
}

TEST_F(ScenarioFile, StepsAreChecked) {
  EXPECT_EQ(StepErrors(R"({"tick": 5})").rfind(R"(unknown member "tick")", 0), 0U);
  EXPECT_EQ(StepErrors(R"({"halt": true, "ticks": 2})"), "a step either ticks or halts the tree\n");
  EXPECT_EQ(StepErrors(R"({"ticks": -1})"), "expected a whole number from 0 to 1000000\n");
  EXPECT_EQ(StepErrors(R"({"ticks": 1.5})"), "expected a whole number from 0 to 1000000\n");
  EXPECT_EQ(StepErrors(R"({"advance_ms": -1})"), "expected a time in milliseconds, not negative\n");
  EXPECT_EQ(StepErrors(R"({"advance_ms": 1e300})"),
            "expected a time in milliseconds, not negative\n");
  EXPECT_EQ(StepErrors(R"({"set": {"a": [1]}})"),
            "expected a text, a number or a boolean (values of other types are given as text, as "
            "in the XML)\n");
  EXPECT_EQ(StepErrors(R"({"leaves": {"a": "IDLE"}})"),
            "IDLE is not a result that a node may return\n");
  EXPECT_EQ(StepErrors(R"({"leaves": {"a": {"return": "SUCCESS"}}})")
                .rfind(R"(unknown member "return")", 0),
            0U);
}

TEST_F(ScenarioFile, ExpectationsAreChecked) {
  EXPECT_EQ(StepErrors(R"({"expect": {"status": "SUCCES"}})"),
            "expected a status: RUNNING, SUCCESS, FAILURE, SKIPPED or IDLE (did you mean "
            "\"SUCCESS\"?)\n");
  for (const char* event : {"[]", "5", R"(["halt"])", R"(["halt", "a", "SUCCESS"])", R"(["run"])",
                            R"(["tick", 5])", R"(["tick", "a", "x"])"}) {
    EXPECT_NE(StepErrors(std::string(R"({"expect": {"events": [)") + event + "]}}"), "") << event;
  }
  EXPECT_EQ(StepErrors(R"({"expect": {"state": "SUCCESS"}})").rfind("unknown member", 0), 0U);
}

TEST_F(ScenarioFile, ChancesHaveSharesAndARange) {
  const auto suite = Load(R"({"tree": "a.xml", "leaves": {
    "a": {"chances": {"FAILURE": 2, "after_ms": 50}, "says": "no"}},
    "scenarios": [{"name": "s", "seed": 18446744073709, "steps": [{}]}]})");
  ASSERT_TRUE(suite) << errors_;
  const Chances& chances = *suite->leaves[0].rule.script.chances;
  EXPECT_EQ(chances.failure, 2);
  EXPECT_EQ(chances.shortest, std::chrono::milliseconds(50));
  EXPECT_EQ(chances.longest, std::chrono::milliseconds(50));
  EXPECT_EQ(suite->scenarios[0].seed, 18446744073709U);
  const auto errors = [this](const std::string& script) {
    return StepErrors(R"({"leaves": {"a": )" + script + "}}");
  };
  EXPECT_NE(errors(R"({"chances": {}})").find("needs a share"), std::string::npos);
  EXPECT_NE(errors(R"({"chances": {"SUCCESS": -1}})").find("not negative"), std::string::npos);
  EXPECT_NE(errors(R"({"chances": {"SUCCESS": 1, "after_ms": [2, 1]}})").find("the shortest"),
            std::string::npos);
  EXPECT_NE(errors(R"({"chances": {"SUCCESS": 1}, "returns": "FAILURE"})").find("stands for"),
            std::string::npos);
  EXPECT_NE(errors(R"({"chances": {"RUNNING": 1}})").find("unknown member"), std::string::npos);
}

}  // namespace
}  // namespace coppice
