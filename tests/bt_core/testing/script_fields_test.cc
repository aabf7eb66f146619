#include "bt_core/testing/script_fields.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

using std::chrono::milliseconds;

class Fields : public ScriptFields {
 public:
  using ScriptFields::ReadRules;
  using ScriptFields::ScriptFields;
};

class ScriptFieldsTest : public testing::Test {
 protected:
  MockScript Read(const std::string& script) {
    const auto json = ParseJson("{\"a\": " + script + "}", "a.json", diagnostics_);
    if (!json) return {};
    const std::vector<PlacedRule> rules = Fields(diagnostics_).ReadRules(*json);
    return rules.empty() ? MockScript() : rules[0].rule.script;
  }
  // The first error of a script, without the place.
  std::string Error(const std::string& script) {
    diagnostics_ = {};
    Read(script);
    return diagnostics_.has_errors() ? diagnostics_.all()[0].message : "";
  }

  Diagnostics diagnostics_;
};

TEST_F(ScriptFieldsTest, AResultOrAListIsAScript) {
  EXPECT_EQ(Read("\"FAILURE\"").results, std::vector<Status>{Status::kFailure});
  EXPECT_EQ(Read("[\"RUNNING\", \"SUCCESS\"]").results,
            (std::vector<Status>{Status::kRunning, Status::kSuccess}));
  EXPECT_EQ(diagnostics_.ToString(), "");
}

TEST_F(ScriptFieldsTest, ChancesHaveTimesAndMayHold) {
  const MockScript script =
      Read(R"({"chances": {"SUCCESS": 8, "SKIPPED": 2, "after_ms": [1, 2], "holds_ms": 500}})");
  ASSERT_TRUE(script.chances) << diagnostics_.ToString();
  EXPECT_EQ(script.chances->success, 8);
  EXPECT_EQ(script.chances->failure, 0);
  EXPECT_EQ(script.chances->skipped, 2);
  EXPECT_EQ(script.chances->shortest, milliseconds(1));
  EXPECT_EQ(script.chances->longest, milliseconds(2));
  EXPECT_EQ(script.chances->shortest_hold, milliseconds(500));
  EXPECT_EQ(script.chances->longest_hold, milliseconds(500));
}

TEST_F(ScriptFieldsTest, AListOfOutputsIsOneByChance) {
  const MockScript script = Read(R"({"outputs": {"goal": "1;2", "rung": [0, 1]}})");
  using Texts = std::vector<std::string>;
  ASSERT_EQ(script.outputs.size(), 1U);
  EXPECT_EQ(script.outputs[0], std::pair(std::string("goal"), std::string("1;2")));
  ASSERT_EQ(script.outputs_by_chance.size(), 1U);
  EXPECT_EQ(script.outputs_by_chance[0], std::pair(std::string("rung"), Texts({"0", "1"})));
}

TEST_F(ScriptFieldsTest, WhatIsWrongIsSaid) {
  EXPECT_EQ(Error("\"IDLE\""), "IDLE is not a result that a node may return");
  EXPECT_EQ(Error("\"DONE\""), "expected a status: RUNNING, SUCCESS, FAILURE, SKIPPED or IDLE");
  EXPECT_EQ(Error(R"({"chances": {}})"),
            "\"chances\" needs a share of SUCCESS, FAILURE or SKIPPED");
  EXPECT_EQ(Error(R"({"chances": {"SUCCESS": -1}})"), "expected a share, not negative");
  EXPECT_EQ(Error(R"({"chances": {"SUCCESS": 1, "holds_ms": [2, 1]}})"),
            "expected the shortest and the longest time");
  EXPECT_EQ(Error(R"({"chances": {"SUCCESS": 1}, "after_ms": 5})"),
            "\"chances\" stands for \"returns\" and \"after_ms\"");
  EXPECT_EQ(Error(R"({"outputs": {"rung": []}})"), "expected at least one value");
  EXPECT_EQ(Error(R"({"retruns": "SUCCESS"})").substr(0, 24), "unknown member \"retruns\"");
}

}  // namespace
}  // namespace coppice
