#include <sys/stat.h>

#include "tests/bt_core/cli/fixture.h"

namespace coppice {
namespace {

class TestVerb : public CliTest {
 protected:
  std::string WriteScenario(const std::string& status) {
    WriteTree(R"(<Sequence><Go name="a"/><AlwaysSuccess/></Sequence>)");
    return Write("a.test.json", R"({"tree": "tree.xml", "leaves": {"a": ["RUNNING", "SUCCESS"]},
 "scenarios": [
  {"name": "ends", "steps": [{}, {"expect": {"status": ")" +
                                    status + R"("}}]},
  {"name": "starts", "steps": [{"expect": {"events": [["tick", "a", "RUNNING"]]}}]}
 ]})");
  }
};

TEST_F(TestVerb, PassesWhenAllScenariosDo) {
  const std::string file = WriteScenario("SUCCESS");
  EXPECT_EQ(Run(RunTest, {file}), 0);
  EXPECT_EQ(out_, "ok    " + file + ": ends\nok    " + file + ": starts\n2 passed, 0 failed\n");
}

TEST_F(TestVerb, TellsTheLineOfTheExpectationThatFailed) {
  const std::string file = WriteScenario("FAILURE");
  EXPECT_EQ(Run(RunTest, {file}), 1);
  EXPECT_NE(out_.find(file + ":3:56: step 2: status of the tree\n"
                             "    expected FAILURE\n    got      SUCCESS\n"),
            std::string::npos)
      << out_;
}

TEST_F(TestVerb, PlaysOnlyWhatTheFilterFits) {
  const std::string file = WriteScenario("FAILURE");
  EXPECT_EQ(Run(RunTest, {file, "--filter", "st*"}), 0);
  EXPECT_EQ(Run(RunTest, {file, "--filter", "x*"}), 2);
  EXPECT_EQ(err_, "no scenario fits \"x*\"\n");
}

TEST_F(TestVerb, ATreeOrFileWithErrorsIsAnError) {
  const std::string file = WriteScenario("SUCCESS");
  Write("tree.xml", "<root/>");
  EXPECT_EQ(Run(RunTest, {file}), 2);
  EXPECT_NE(out_.find("tree.xml:1:1: error:"), std::string::npos) << out_;
  EXPECT_EQ(Run(RunTest, {Write("b.test.json", "{}")}), 2);
  EXPECT_EQ(Run(RunTest, {}), 2);
}

TEST_F(TestVerb, AMisspeltDecoratorIsToldWithTheRightName) {
  WriteTree("<Invertr><AlwaysFailure/></Invertr>");
  const std::string file =
      Write("a.test.json", R"({"tree": "tree.xml", "scenarios": [{"name": "a", "steps": [{}]}]})");
  EXPECT_EQ(Run(RunTest, {file}), 1);
  EXPECT_NE(out_.find("whose type <Invertr> is not known here\n"
                      R"(    got      none, did you mean "Inverter"?)"),
            std::string::npos)
      << out_;
}

TEST_F(TestVerb, AModelOrAScriptMakesADecoratorKnown) {
  WriteTree("<Guarded><AlwaysFailure/></Guarded>");
  const std::string models =
      Write("models.xml", R"(<root BTCPP_format="4"><TreeNodesModel><Decorator )"
                          R"(ID="Guarded"/></TreeNodesModel></root>)");
  const std::string steps =
      R"("scenarios": [{"name": "a", "steps": [{"expect": {"status": "FAILURE"}}]}]})";
  const std::string plain = Write("a.test.json", R"({"tree": "tree.xml", )" + steps);
  EXPECT_EQ(Run(RunTest, {plain}), 1);
  EXPECT_EQ(Run(RunTest, {plain, "--models", models}), 0) << out_;
  EXPECT_EQ(Run(RunTest, {plain, "--models", "nowhere.xml"}), 2);
  EXPECT_EQ(Run(RunTest,
                {Write("b.test.json", R"({"tree": "tree.xml", "models": "models.xml", )" + steps)}),
            0)
      << out_;
  EXPECT_EQ(Run(RunTest, {Write("c.test.json", R"({"tree": "tree.xml",
                                "leaves": {"<Guarded>": "FAILURE"}, )" +
                                                   steps)}),
            0)
      << out_;
}

TEST_F(TestVerb, WritesJsonAndJUnit) {
  const std::string file = WriteScenario("SUCCESS");
  const std::string junit = (folder_ / "out.xml").string();
  EXPECT_EQ(Run(RunTest, {file, "--json", "--junit", junit}), 0);
  EXPECT_EQ(out_.rfind(R"({"passed":true,)", 0), 0U);
  EXPECT_TRUE(std::filesystem::file_size(junit) > 100);
  EXPECT_EQ(Run(RunTest, {file, "--junit", "/nowhere/out.xml"}), 2);
  const std::string pipe = (folder_ / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(Run(RunTest, {file, "--junit", pipe}), 2) << "nobody reads it";
}

}  // namespace
}  // namespace coppice
