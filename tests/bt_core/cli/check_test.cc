#include "tests/bt_core/cli/fixture.h"

namespace coppice {
namespace {

class CheckTest : public CliTest {};

TEST_F(CheckTest, AGoodFileIsQuiet) {
  EXPECT_EQ(Run(RunCheck, {WriteTree("<Sequence><RobotLeaf x=\"1\"/></Sequence>")}), 0);
  EXPECT_EQ(out_ + err_, "");
}

TEST_F(CheckTest, PrintsEveryProblemOnce) {
  const std::string file = Write("a.xml",
                                 "<root BTCPP_format=\"4\">\n"
                                 "<BehaviorTree ID=\"A\"><SubTree ID=\"B\"/></BehaviorTree>\n"
                                 "<BehaviorTree ID=\"B\"><Sequence/></BehaviorTree></root>");
  EXPECT_EQ(Run(RunCheck, {file}), 1);
  EXPECT_EQ(err_, file + ":3:22: error: Sequence has 0 children, expected at least 1\n");
}

TEST_F(CheckTest, ChecksAllFiles) {
  const std::string bad = Write("bad.xml", "<root>");
  EXPECT_EQ(Run(RunCheck, {bad, WriteTree("<Sequense><AlwaysSuccess/></Sequense>")}), 1);
  EXPECT_NE(err_.find("bad.xml:1:1: error"), std::string::npos) << err_;
  EXPECT_NE(err_.find("did you mean \"Sequence\"?"), std::string::npos) << err_;
}

TEST_F(CheckTest, WithoutFileItShowsTheUsage) {
  EXPECT_EQ(Run(RunCheck, {}), 2);
  EXPECT_NE(err_.find("usage: coppice check FILE"), std::string::npos);
}

TEST_F(CheckTest, UnknownOptionIsWrongUsage) { EXPECT_EQ(Run(RunCheck, {"--fast"}), 2); }

}  // namespace
}  // namespace coppice
