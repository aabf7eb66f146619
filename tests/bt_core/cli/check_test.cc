#include "tests/bt_core/cli/fixture.h"

namespace coppice {
namespace {

class CheckTest : public CliTest {};

TEST_F(CheckTest, AGoodFileIsQuiet) {
  EXPECT_EQ(Run(RunCheck, {WriteTree("<Sequence><AlwaysSuccess/></Sequence>")}), 0);
  EXPECT_EQ(out_ + err_, "");
}

TEST_F(CheckTest, AWarningIsNoFailure) {
  const std::string file = WriteTree("<Sequence><RobotLeaf x=\"1\"/></Sequence>");
  EXPECT_EQ(Run(RunCheck, {file}), 0);
  EXPECT_NE(err_.find(file + ":3:11: warning: node type \"RobotLeaf\""), std::string::npos) << err_;
}

TEST_F(CheckTest, PrintsEveryProblemOnceInTheOrderOfTheText) {
  const std::string file =
      Write("a.xml",
            "<root BTCPP_format=\"4\">\n"
            "<BehaviorTree ID=\"A\"><SubTree ID=\"B\"/></BehaviorTree>\n"
            "<BehaviorTree ID=\"B\"><Sequence/></BehaviorTree>\n"
            "<BehaviorTree ID=\"Z\"><Sequence>\n<AlwaysSuccess _skipIf=\")\"/>\n"
            "<Inverter/></Sequence></BehaviorTree></root>");
  EXPECT_EQ(Run(RunCheck, {file}), 1);
  EXPECT_EQ(err_.find(file + ":3:22: error: Sequence has 0 children, expected at least 1\n"), 0U);
  const std::size_t script = err_.find(file + ":5:");
  const std::size_t children = err_.find(file + ":6:1: error: Inverter has 0 children");
  EXPECT_NE(children, std::string::npos) << err_;
  EXPECT_LT(script, children) << err_;
}

TEST_F(CheckTest, SeveralFilesAreOneProject) {
  const std::string main = Write("main.xml",
                                 "<root BTCPP_format=\"4\"><BehaviorTree ID=\"A\">"
                                 "<SubTree ID=\"B\"/></BehaviorTree></root>");
  const std::string other = Write("other.xml",
                                  "<root BTCPP_format=\"4\"><BehaviorTree ID=\"B\">"
                                  "<AlwaysSuccess/></BehaviorTree></root>");
  EXPECT_EQ(Run(RunCheck, {main, other}), 0);
  EXPECT_EQ(err_, "");
  EXPECT_EQ(Run(RunCheck, {main}), 0);
  EXPECT_EQ(err_, main +
                      ":1:45: warning: tree \"B\" is not among these files "
                      "(other.xml has it; include that file)\n");
}

TEST_F(CheckTest, AFileThatCannotBeReadDoesNotHideTheProblemsOfTheOthers) {
  const std::string bad = Write("bad.xml", "<root>");
  EXPECT_EQ(Run(RunCheck, {bad, WriteTree("<Inverter/>")}), 1);
  EXPECT_NE(err_.find("bad.xml:1:1: error"), std::string::npos) << err_;
  EXPECT_NE(err_.find("Inverter has 0 children"), std::string::npos) << err_;
}

TEST_F(CheckTest, ANodeOfTheRobotMayHaveTheNameOfABuiltInOne) {
  const std::string models = Write("models.xml",
                                   "<root BTCPP_format=\"4\"><TreeNodesModel>"
                                   "<Action ID=\"Cooldown\"><input_port name=\"motor\"/></Action>"
                                   "</TreeNodesModel></root>");
  const std::string file = WriteTree("<Cooldown motor=\"left\"/>");
  EXPECT_EQ(Run(RunCheck, {file}), 1);
  EXPECT_EQ(Run(RunCheck, {file, "--models", models}), 0);
  EXPECT_EQ(
      err_,
      models +
          ":1:40: warning: \"Cooldown\" of this model is of category Action, but the built-in "
          "Decorator of that name is not (trees are checked against the model)\n");
}

TEST_F(CheckTest, ModelsTellAboutTheLeavesOfTheRobot) {
  const std::string models = Write("models.xml",
                                   "<root BTCPP_format=\"4\"><TreeNodesModel><Action ID=\"Go\">"
                                   "<input_port name=\"speed\" type=\"double\"/></Action>"
                                   "</TreeNodesModel></root>");
  const std::string file = WriteTree("<Sequence><Go speed=\"fast\"/><Gone/></Sequence>");
  EXPECT_EQ(Run(RunCheck, {file, "--models", models}), 1);
  EXPECT_EQ(err_, file +
                      ":3:22: error: \"fast\" is not a value for port \"speed\" of Go "
                      "(expected double)\n" +
                      file + ":3:29: error: unknown node type \"Gone\"\n");
}

TEST_F(CheckTest, JsonHasOneObjectForEachProblem) {
  const std::string file = WriteTree("<Sequense><AlwaysSuccess/></Sequense>");
  EXPECT_EQ(Run(RunCheck, {file, "--json"}), 0);
  EXPECT_EQ(out_, "[\n  {\"file\":\"" + file +
                      "\",\"line\":3,\"column\":1,\"severity\":\"warning\",\"message\":\"node type "
                      "\\\"Sequense\\\" is not built in: its ports are not checked, nor how many "
                      "children it may have\",\"hint\":\"did you mean \\\"Sequence\\\"?\"}\n]\n");
  EXPECT_EQ(err_, "");
  EXPECT_EQ(Run(RunCheck, {WriteTree("<AlwaysSuccess/>"), "--json"}), 0);
  EXPECT_EQ(out_, "[]\n");
}

TEST_F(CheckTest, TypesThatNobodyDescribesAreOneLineForEachFile) {
  const std::string file = WriteTree("<Sequence><Go/><Wait/><Go/><Say/></Sequence>");
  EXPECT_EQ(Run(RunCheck, {file}), 0);
  EXPECT_EQ(err_, file +
                      ":3:11: warning: 3 node types are not built in: their ports are not checked, "
                      "nor their numbers of children (Go, Wait, Say)\n");
  EXPECT_EQ(Run(RunCheck, {file, "--json"}), 0);
  EXPECT_NE(out_.find("node type \\\"Wait\\\" is not built in"), std::string::npos) << out_;
}

TEST_F(CheckTest, WithoutFileItSaysWhatItExpects) {
  EXPECT_EQ(Run(RunCheck, {}), 2);
  EXPECT_EQ(err_, "coppice check: expected FILE...; see coppice check --help\n");
}

TEST_F(CheckTest, UnknownOptionIsWrongUsage) { EXPECT_EQ(Run(RunCheck, {"--fast"}), 2); }

}  // namespace
}  // namespace coppice
