#include "bt_core/cli/replay/replay.h"
#include "tests/bt_core/cli/fixture.h"

namespace coppice {
namespace {

class RunTest : public CliTest {};

TEST_F(RunTest, PrintsTheChangesAndTheResult) {
  EXPECT_EQ(CliTest::Run(RunTree, {WriteTree("<Inverter><AlwaysFailure name=\"no\"/></Inverter>")}),
            0);
  EXPECT_EQ(out_, "tick 1  no  IDLE -> FAILURE\ntick 1  Inverter::1  IDLE -> SUCCESS\nSUCCESS\n");
}

TEST_F(RunTest, AFailedTreeIsExitStatus1) {
  EXPECT_EQ(CliTest::Run(RunTree, {WriteTree("<AlwaysFailure/>")}), 1);
}

TEST_F(RunTest, RunsTheTreeThatIsAskedFor) {
  const std::string file =
      Write("two.xml", R"(<root BTCPP_format="4">)"
                       R"(<BehaviorTree ID="A"><AlwaysFailure/></BehaviorTree>)"
                       R"(<BehaviorTree ID="B"><AlwaysSuccess/></BehaviorTree></root>)");
  EXPECT_EQ(CliTest::Run(RunTree, {file, "--tree", "B"}), 0);
  EXPECT_EQ(CliTest::Run(RunTree, {file}), 2);
  EXPECT_NE(err_.find("which tree is the main one?"), std::string::npos);
}

TEST_F(RunTest, LeavesOfTheRobotAreUnknown) {
  EXPECT_EQ(CliTest::Run(RunTree, {WriteTree("<DriveTo/>")}), 2);
  EXPECT_NE(err_.find(R"(unknown node type "DriveTo")"), std::string::npos);
}

TEST_F(RunTest, QuietPrintsTheResultOnly) {
  EXPECT_EQ(CliTest::Run(RunTree, {WriteTree("<AlwaysSuccess/>"), "--quiet"}), 0);
  EXPECT_EQ(out_, "SUCCESS\n");
}

TEST_F(RunTest, RecordsTheRun) {
  const std::string record = (folder_ / "run.coppice").string();
  const std::string tree = WriteTree("<Inverter><AlwaysFailure/></Inverter>");
  EXPECT_EQ(CliTest::Run(RunTree, {tree, "--record", record}), 0);
  EXPECT_EQ(CliTest::Run(RunReplay, {"--verify", record}), 0) << err_;
  EXPECT_NE(out_.find("3 events: the same"), std::string::npos) << out_;
  EXPECT_EQ(CliTest::Run(RunTree, {tree, "--record", record}), 2);
  EXPECT_NE(err_.find("run.coppice"), std::string::npos) << err_;
}

TEST_F(RunTest, NeedsOneFile) {
  EXPECT_EQ(CliTest::Run(RunTree, {}), 2);
  EXPECT_EQ(CliTest::Run(RunTree, {"a.xml", "b.xml"}), 2);
}

}  // namespace
}  // namespace coppice
