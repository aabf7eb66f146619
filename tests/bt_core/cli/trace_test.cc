#include "tests/bt_core/cli/fixture.h"

namespace coppice {
namespace {

class TraceTest : public CliTest {};

TEST_F(TraceTest, PrintsTicksAndHaltsOfTheLeaves) {
  const std::string tree =
      WriteTree("<ReactiveSequence><Door name=\"open\"/><Drive name=\"go\"/></ReactiveSequence>");
  const std::string script =
      Write("s.json", R"({"leaves": {"open": ["SUCCESS", "FAILURE"], "go": ["RUNNING"]}})");
  EXPECT_EQ(Run(RunTrace, {tree, "--leaves", script, "--ticks", "2"}), 0);
  EXPECT_EQ(out_,
            R"({"tick":1,"status":"RUNNING","events":[["tick","open","SUCCESS"],)"
            R"(["tick","go","RUNNING"]]})"
            "\n"
            R"({"tick":2,"status":"FAILURE","events":[["tick","open","FAILURE"],["halt","go"]]})"
            "\n");
}

TEST_F(TraceTest, ALeafWithoutScriptSucceeds) {
  EXPECT_EQ(Run(RunTrace, {WriteTree("<Door/>")}), 0);
  EXPECT_EQ(out_, R"({"tick":1,"status":"SUCCESS","events":[["tick","Door","SUCCESS"]]})"
                  "\n");
}

TEST_F(TraceTest, ABadTreeIsALoadError) {
  EXPECT_EQ(Run(RunTrace, {WriteTree("<Sequence/>")}), 2);
  EXPECT_EQ(out_, "{\"load_error\":true}\n");
}

TEST_F(TraceTest, RefusesScriptsThatAreNone) {
  const std::string tree = WriteTree("<Door/>");
  for (const char* text : {"", "[]", "{}", R"({"leaves": 5})", R"({"leaves": {"a": ["GREAT"]}})",
                           R"({"leaves": {"a": ["IDLE"]}})"}) {
    EXPECT_EQ(Run(RunTrace, {tree, "--leaves", Write("s.json", text)}), 2) << text;
    EXPECT_NE(err_.find("s.json: error:"), std::string::npos) << text;
  }
}

TEST_F(TraceTest, TicksAreANumber) {
  EXPECT_EQ(Run(RunTrace, {WriteTree("<Door/>"), "--ticks", "many"}), 2);
  EXPECT_EQ(Run(RunTrace, {WriteTree("<Door/>"), "--ticks", "-1"}), 2);
}

}  // namespace
}  // namespace coppice
