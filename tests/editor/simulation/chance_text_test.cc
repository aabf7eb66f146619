#include "editor/simulation/chance_text.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

RandomPlay Parsed(const std::string& random) {
  Diagnostics diagnostics;
  auto suite = ParseScenarios("{\"tree\": \"a.xml\",\n\"random\": " + random +
                                  R"(, "scenarios": [{"name": "a", "steps": [{}]}]})",
                              "trees/a.test.json", diagnostics);
  EXPECT_TRUE(suite) << diagnostics.ToString();
  return suite ? *suite->random : RandomPlay();
}

TEST(ChanceText, SaysWhereItStands) {
  EXPECT_EQ(OriginOf(Parsed("{}")), "a.test.json:2");
  EXPECT_EQ(OriginOf({}), "");
}

TEST(ChanceText, SaysKeysNodesAndTime) {
  const RandomPlay play = Parsed(
      R"({"set": {"stops": [1, 2, 3], "place": "lab", "night": [true, false]},
          "leaves": {"<*Fault>": {"chances": {"SUCCESS": 1, "FAILURE": 4, "holds_ms": [0, 60000]}},
                     "dock": ["RUNNING", "SUCCESS"]},
          "lasts_ms": 600000})");
  EXPECT_EQ(LinesOf(play),
            (std::vector<std::string>{"stops: 1, 2 or 3", "place: lab", "night: true or false",
                                      "<*Fault>: 20% SUCCESS 80% FAILURE holds 0ms..60s",
                                      "dock: RUNNING SUCCESS", "for 600s"}));
  EXPECT_TRUE(LinesOf(Parsed("{}")).empty());
}

}  // namespace
}  // namespace coppice::editor
