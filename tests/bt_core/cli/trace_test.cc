#include "tests/bt_core/cli/fixture.h"

namespace coppice {
namespace {

class TraceTest : public CliTest {};

TEST_F(TraceTest, PrintsTicksAndHaltsOfTheLeaves) {
  const std::string tree =
      WriteTree(R"(<ReactiveSequence><Door name="open"/><Drive name="go"/></ReactiveSequence>)");
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

TEST_F(TraceTest, ATickThatThrowsEndsTheTrace) {
  const std::string tree = WriteTree(
      R"(<Sequence><Go name="a"/><Parallel success_count="2"><Go/></Parallel></Sequence>)");
  const std::string script = Write("s.json", R"({"leaves": {"a": ["RUNNING", "SUCCESS"]}})");
  EXPECT_EQ(Run(RunTrace, {tree, "--leaves", script, "--ticks", "5"}), 0);
  EXPECT_EQ(out_, R"({"tick":1,"status":"RUNNING","events":[["tick","a","RUNNING"]]})"
                  "\n{\"tick\":2,\"error\":true}\n");
  EXPECT_NE(err_.find("tick 2:"), std::string::npos) << err_;
}

TEST_F(TraceTest, ASkippedLeafIsTickedAgainAndNotHalted) {
  const std::string tree = WriteTree(
      R"(<ReactiveFallback><Go name="a"/><Sequence><Go name="b"/><Go name="c"/></Sequence>)"
      "</ReactiveFallback>");
  const std::string script =
      Write("s.json", R"({"leaves": {"a": ["SKIPPED", "SKIPPED", "SUCCESS"], "b": ["SKIPPED"],
                               "c": ["RUNNING"]}})");
  EXPECT_EQ(Run(RunTrace, {tree, "--leaves", script, "--ticks", "3"}), 0);
  EXPECT_EQ(out_, R"({"tick":1,"status":"RUNNING","events":[["tick","a","SKIPPED"],)"
                  R"(["tick","b","SKIPPED"],["tick","c","RUNNING"]]})"
                  "\n"
                  R"({"tick":2,"status":"RUNNING","events":[["tick","a","SKIPPED"],)"
                  R"(["tick","c","RUNNING"]]})"
                  "\n"
                  R"({"tick":3,"status":"SUCCESS","events":[["tick","a","SUCCESS"],["halt","c"]]})"
                  "\n");
}

// Every use of a SubTree has leaves of its own, each at its own place of the common script.
TEST_F(TraceTest, LeavesInSubTreesGoByTheirOwnName) {
  const std::string tree = Write("tree.xml", R"(
<root BTCPP_format="4" main_tree_to_execute="Main">
 <BehaviorTree ID="Main"><Sequence><SubTree ID="In"/><SubTree ID="In" name="again"/></Sequence>
 </BehaviorTree>
 <BehaviorTree ID="In"><Go name="a"/></BehaviorTree>
</root>)");
  const std::string script = Write("s.json", R"({"leaves": {"a": ["RUNNING", "SUCCESS"]}})");
  EXPECT_EQ(Run(RunTrace, {tree, "--leaves", script, "--ticks", "3"}), 0);
  EXPECT_EQ(
      out_,
      R"({"tick":1,"status":"RUNNING","events":[["tick","a","RUNNING"]]})"
      "\n"
      R"({"tick":2,"status":"RUNNING","events":[["tick","a","SUCCESS"],["tick","a","RUNNING"]]})"
      "\n"
      R"({"tick":3,"status":"SUCCESS","events":[["tick","a","SUCCESS"]]})"
      "\n");
}

TEST_F(TraceTest, TimeStandsAlmostStillWithoutAStep) {
  const std::string tree = WriteTree(R"(<Timeout msec="10"><Go name="a"/></Timeout>)");
  const std::string script = Write("s.json", R"({"leaves": {"a": ["RUNNING"]}})");
  EXPECT_EQ(Run(RunTrace, {tree, "--leaves", script, "--ticks", "50"}), 0);
  EXPECT_EQ(out_.find("FAILURE"), std::string::npos);
}

TEST_F(TraceTest, AStepLetsTimePass) {
  const std::string tree = WriteTree(R"(<Timeout msec="10"><Go name="a"/></Timeout>)");
  const std::string script = Write("s.json", R"({"leaves": {"a": ["RUNNING"]}})");
  EXPECT_EQ(Run(RunTrace, {tree, "--leaves", script, "--ticks", "3", "--step", "5"}), 0);
  EXPECT_NE(out_.find(R"({"tick":3,"status":"FAILURE","events":[["halt","a"]]})"),
            std::string::npos)
      << out_;
  EXPECT_EQ(Run(RunTrace, {tree, "--step", "-5"}), 2);
}

}  // namespace
}  // namespace coppice
