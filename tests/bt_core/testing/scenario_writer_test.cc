#include "bt_core/testing/scenario_writer.h"

#include <gtest/gtest.h>

#include "tests/bt_core/testing/with_stand_ins.h"

namespace coppice {
namespace {

constexpr char kText[] = R"({
  "tree": "drive_to.xml",
  "tree_id": "DriveTo",
  "models": "../models.xml",
  "leaves": {
    "<NavigateTo>": ["FAILURE", "RUNNING", "SUCCESS"],
    "<Grasp>": {"chances": {"SUCCESS": 8, "FAILURE": 1.5, "SKIPPED": 1, "after_ms": [100, 2000]}},
    "<IsDay>": {"chances": {"SUCCESS": 1, "holds_ms": [0, 5000]}, "outputs": {"hour": ["8", "9"]}},
    "<Wait>": {
      "after_ms": 5000.25,
      "returns": "FAILURE",
      "restart": true,
      "outputs": {"path": "1;2"},
      "feedback": {"left": "3"},
      "says": "waited \"long\" enough",
      "throws": "broken"
    }
  },
  "random": {
    "set": {"stops": [1, 3], "place": ["lab"]},
    "leaves": {"<Wait>": {"chances": {"SUCCESS": 1}}},
    "lasts_ms": 60000
  },
  "scenarios": [
    {
      "name": "tries again",
      "seed": 7,
      "leaves": {"speak": "SKIPPED"},
      "own_leaves": true,
      "steps": [
        {
          "set": {"goal": "1;2", "n": -2.50, "patrol/done": false},
          "leaves": {"<Wait>": "SUCCESS"},
          "advance_ms": 100,
          "ticks": 3,
          "expect": {
            "status": "RUNNING",
            "nodes": {"until_there": "RUNNING"},
            "events": [["tick", "NavigateTo", "FAILURE", {"goal": "1;2"}], ["halt", "Wait"]],
            "blackboard": {"n": 4, "never": null},
            "messages": ["stuck"]
          }
        },
        {"halt": true}
      ]
    }
  ]
}
)";

ScenarioSuite Parsed(const std::string& text) {
  Diagnostics diagnostics;
  auto suite = ParseScenarios(text, "trees/drive_to.test.json", diagnostics);
  EXPECT_TRUE(suite) << diagnostics.ToString();
  return suite ? *std::move(suite) : ScenarioSuite();
}

TEST(ScenarioWriter, WritesWhatWasRead) { EXPECT_EQ(PrintScenarios(Parsed(kText)), kText); }

TEST(ScenarioWriter, AScenarioIsAddedBehindTheOthersAndNothingElseChanges) {
  const std::string text =
      "// comment\n{ \"tree\": \"a.xml\",  \"scenarios\": [\n"
      "  {\"name\": \"one\", \"steps\": [{}]}  // the first ]\n  ] }\n";
  Scenario scenario;
  scenario.name = "two";
  scenario.steps.resize(1);
  Diagnostics diagnostics;
  const auto changed = AddScenario(text, "a.test.json", scenario, diagnostics);
  ASSERT_TRUE(changed) << diagnostics.ToString();
  EXPECT_EQ(*changed,
            "// comment\n{ \"tree\": \"a.xml\",  \"scenarios\": [\n"
            "  {\"name\": \"one\", \"steps\": [{}]},\n"
            "    {\"name\": \"two\", \"steps\": [{}]}  // the first ]\n  ] }\n");
  const ScenarioSuite suite = Parsed(*changed);
  ASSERT_EQ(suite.scenarios.size(), 2U);
  EXPECT_EQ(suite.scenarios[1].name, "two");

  EXPECT_FALSE(AddScenario(*changed, "a.test.json", scenario, diagnostics));
  EXPECT_NE(diagnostics.ToString().find(R"(a.test.json:4:5: error: there is a scenario "two")"),
            std::string::npos)
      << diagnostics.ToString();
}

// A rule by name of the file would decide before the scenario's rule by type.
TEST(ScenarioWriter, RulesOfTheFileDoNotChangeWhatAnAddedScenarioDoes) {
  Diagnostics diagnostics;
  const auto program = CompileWithStandIns(
      R"(<root BTCPP_format="4"><BehaviorTree ID="M"><Go name="go"/></BehaviorTree></root>)",
      diagnostics);
  const std::string text = R"({"tree": "a.xml", "leaves": {"go": "FAILURE"}, "scenarios": )"
                           R"([{"name": "one", "steps": [{"expect": {"status": "FAILURE"}}]}]})";
  PlacedRule goes;
  goes.rule.pattern = "<Go>";
  const Scenario played = RecordScenario(*program, {goes}, std::vector<ScenarioStep>(1), "two");
  const auto changed = AddScenario(text, "a.test.json", played, diagnostics);
  ASSERT_TRUE(changed) << diagnostics.ToString();
  const ScenarioSuite suite = Parsed(*changed);
  ASSERT_EQ(suite.scenarios.size(), 2U);
  EXPECT_EQ(PrintScenarios(Parsed(PrintScenarios(suite))), PrintScenarios(suite));
  for (const Scenario& scenario : suite.scenarios) {
    for (const Difference& difference : RunScenario(*program, suite, scenario).differences) {
      ADD_FAILURE() << scenario.name << ": " << difference.what << ": " << difference.expected
                    << ", got " << difference.got;
    }
  }
}

TEST(ScenarioWriter, AFileThatIsWrongStaysAsItIs) {
  Diagnostics diagnostics;
  EXPECT_FALSE(AddScenario(R"({"tree": 3})", "a.test.json", {}, diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

}  // namespace
}  // namespace coppice
