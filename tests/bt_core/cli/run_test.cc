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
  const std::string file = Write("two.xml",
                                 "<root BTCPP_format=\"4\">"
                                 "<BehaviorTree ID=\"A\"><AlwaysFailure/></BehaviorTree>"
                                 "<BehaviorTree ID=\"B\"><AlwaysSuccess/></BehaviorTree></root>");
  EXPECT_EQ(CliTest::Run(RunTree, {file, "--tree", "B"}), 0);
  EXPECT_EQ(CliTest::Run(RunTree, {file}), 2);
  EXPECT_NE(err_.find("which tree is the main one?"), std::string::npos);
}

TEST_F(RunTest, LeavesOfTheRobotAreUnknown) {
  EXPECT_EQ(CliTest::Run(RunTree, {WriteTree("<DriveTo/>")}), 2);
  EXPECT_NE(err_.find("unknown node type \"DriveTo\""), std::string::npos);
}

TEST_F(RunTest, NeedsOneFile) {
  EXPECT_EQ(CliTest::Run(RunTree, {}), 2);
  EXPECT_EQ(CliTest::Run(RunTree, {"a.xml", "b.xml"}), 2);
}

}  // namespace
}  // namespace coppice
