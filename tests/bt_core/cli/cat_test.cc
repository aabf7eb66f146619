#include "tests/bt_core/cli/fixture.h"

namespace coppice {
namespace {

using CatTest = CliTest;

constexpr const char* kTree =
    "\xEF\xBB\xBF<root BTCPP_format='4'>\r\n"
    "  <BehaviorTree ID=\"Main\">\r\n"
    "    <Timeout  msec = '5' ><!-- c --><A/></Timeout>\r\n"
    "  </BehaviorTree>\r\n"
    "</root>";

TEST_F(CatTest, PrintsEveryByte) {
  const std::string file = Write("t.xml", kTree);
  EXPECT_EQ(Run(RunCat, {file}), 0) << err_;
  EXPECT_EQ(out_, kTree);
  EXPECT_EQ(err_, "");
}

TEST_F(CatTest, SetsAttributes) {
  const std::string file = Write("t.xml", kTree);
  EXPECT_EQ(Run(RunCat, {file, "--set", "Main/Timeout@msec=10", "Main/Timeout/A@text=a@b='<'"}), 0)
      << err_;
  std::string expected = kTree;
  expected.replace(expected.find("'5'"), 3, "'10'");
  expected.replace(expected.find("<A/>"), 4, R"(<A text="a@b='&lt;'"/>)");
  EXPECT_EQ(out_, expected);
}

TEST_F(CatTest, SaysWhatIsWrongWithAnAssignment) {
  const std::string file = Write("t.xml", kTree);
  EXPECT_EQ(Run(RunCat, {file, "--set", "Main/Timout@msec=10"}), 2);
  EXPECT_NE(err_.find(R"(did you mean "Timeout"?)"), std::string::npos) << err_;
  EXPECT_EQ(out_, "");
  for (const char* wrong : {"Main/Timeout", "Main@msec", "Main=5", "Main@=5", "Main@a b=5"}) {
    EXPECT_EQ(Run(RunCat, {file, "--set", wrong}), 2) << wrong;
    EXPECT_NE(err_.find("expected PATH@ATTRIBUTE=VALUE"), std::string::npos) << err_;
  }
}

TEST_F(CatTest, WrongUsageAndUnreadableFilesAreTwo) {
  EXPECT_EQ(Run(RunCat, {}), 2);
  EXPECT_EQ(Run(RunCat, {"a.xml", "b.xml"}), 2);
  EXPECT_EQ(Run(RunCat, {"a.xml", "--set"}), 2);
  EXPECT_EQ(Run(RunCat, {"/no/such.xml"}), 2);
  EXPECT_NE(err_.find("cannot be read: No such file"), std::string::npos);
}

}  // namespace
}  // namespace coppice
