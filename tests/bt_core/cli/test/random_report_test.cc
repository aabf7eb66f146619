#include "bt_core/cli/test/random_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace coppice {
namespace {

Coverage Example() {
  Coverage coverage;
  coverage.first_seed = 7;
  coverage.runs = 3;
  coverage.ticks = 12;
  coverage.results = {0, 1, 2, 0, 0};
  coverage.nodes = {{"main", {0, 9, 2, 1, 0}}, {"go", {1, 5, 2, 0, 0}}, {"call", {}}};
  coverage.findings = {{"go", "no motor", 4, 8, 2}};
  return coverage;
}

TEST(RandomReport, SaysWhatWasReachedAndWhatWasFound) {
  const std::string text = CoverageText(Example());
  EXPECT_EQ(text.rfind("3 runs, seeds 7 to 9, 12 ticks: 2 SUCCESS, 0 FAILURE, 1 broken off\n", 0),
            0U)
      << text;
  EXPECT_NE(text.find("         7         2         0         0         5         1  go\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("never ticked: \n  call\n"), std::string::npos) << text;
  EXPECT_NE(text.find("never FAILURE: \n  go\n"), std::string::npos) << text;
  EXPECT_NE(text.find("go: no motor\n    4 times, first in tick 2 of --seed 8\n"),
            std::string::npos)
      << text;
}

TEST(RandomReport, TheSameAsJson) {
  const auto json = nlohmann::json::parse(CoverageJson(Example()));
  EXPECT_EQ(json["runs"], 3);
  EXPECT_EQ(json["results"]["SUCCESS"], 2);
  EXPECT_EQ(json["nodes"][1]["path"], "go");
  EXPECT_EQ(json["nodes"][1]["halted"], 1);
  EXPECT_EQ(json["never_ticked"], nlohmann::json::array({"call"}));
  EXPECT_EQ(json["findings"][0]["seed"], 8);
}

}  // namespace
}  // namespace coppice
