#include "bt_core/cli/test/test_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace coppice {
namespace {

std::vector<TestedFile> Mixed() {
  TestedScenario good{"good", {{}, 3}, 0.5};
  TestedScenario bad{"bad & <ugly>", {{}, 2}, 0};
  bad.result.differences = {
      {{"a.json", 4, 5}, 2, "status of the tree", "SUCCESS", "FAILURE"},
      {{"a.json", 1, 1}, 0, "leaves", "a rule", "none"},
  };
  return {{"a.json", "", {good, bad}}, {"b.json", "b.json:1:1: error: no\n", {}}};
}

TEST(TestReport, TellsPeopleWhatDiffered) {
  EXPECT_EQ(ReportText(Mixed()),
            "ok    a.json: good\n"
            "FAIL  a.json: bad & <ugly>\n"
            "  a.json:4:5: step 2: status of the tree\n"
            "    expected SUCCESS\n"
            "    got      FAILURE\n"
            "  a.json:1:1: leaves\n"
            "    expected a rule\n"
            "    got      none\n"
            "b.json:1:1: error: no\n"
            "1 passed, 1 failed\n");
}

TEST(TestReport, IsJsonForPrograms) {
  const auto json = nlohmann::json::parse(ReportJson(Mixed()));
  EXPECT_EQ(json["passed"], false);
  const auto& scenarios = json["files"][0]["scenarios"];
  EXPECT_EQ(scenarios[0]["name"], "good");
  EXPECT_EQ(scenarios[0]["passed"], true);
  EXPECT_EQ(scenarios[0]["ticks"], 3);
  EXPECT_EQ(scenarios[1]["differences"][0],
            nlohmann::json::parse(R"({"line": 4, "column": 5, "step": 2,
              "what": "status of the tree", "expected": "SUCCESS", "got": "FAILURE"})"));
  EXPECT_EQ(json["files"][1]["errors"], "b.json:1:1: error: no\n");
}

TEST(TestReport, IsJUnitForContinuousIntegration) {
  EXPECT_EQ(ReportJUnit(Mixed()),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuites>\n"
            "  <testsuite name=\"a.json\" tests=\"2\" failures=\"1\" errors=\"0\">\n"
            "    <testcase name=\"good\" time=\"0.5\"></testcase>\n"
            "    <testcase name=\"bad &amp; &lt;ugly&gt;\" time=\"0\">\n"
            "      <failure message=\"a.json:4:5: step 2: status of the tree&#10;    expected "
            "SUCCESS&#10;    got      FAILURE&#10;\"/>\n"
            "      <failure message=\"a.json:1:1: leaves&#10;    expected a rule&#10;    got      "
            "none&#10;\"/>\n"
            "    </testcase>\n"
            "  </testsuite>\n"
            "  <testsuite name=\"b.json\" tests=\"1\" failures=\"0\" errors=\"1\">\n"
            R"(    <testcase name="load"><error message="b.json:1:1: error: no&#10;"/>)"
            "</testcase>\n"
            "  </testsuite>\n"
            "</testsuites>\n");
}

TEST(TestReport, AFileThatCouldNotBePlayedHasNotPassed) {
  const std::vector<TestedFile> files = Mixed();
  EXPECT_FALSE(Passed(files[0]));
  EXPECT_FALSE(Passed(files[1]));
  EXPECT_TRUE(Passed({"c.json", "", {files[0].scenarios[0]}}));
}

}  // namespace
}  // namespace coppice
