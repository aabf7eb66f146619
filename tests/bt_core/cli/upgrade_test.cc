#include <sstream>

#include "tests/bt_core/cli/fixture.h"

namespace coppice {
namespace {

class UpgradeTest : public CliTest {
 protected:
  static std::string Read(const std::string& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
};

constexpr const char* kOld =
    "<root>\n<!-- ---- -->\n<BehaviorTree ID='M'><SequenceStar/></BehaviorTree>\n</root>\n";
constexpr const char* kNew =
    "<root BTCPP_format=\"4\">\n<!-- ==== -->\n"
    "<BehaviorTree ID='M'><SequenceWithMemory/></BehaviorTree>\n</root>\n";

TEST_F(UpgradeTest, PrintsTheNewFile) {
  const std::string file = Write("t.xml", kOld);
  EXPECT_EQ(Run(RunUpgrade, {file}), 0);
  EXPECT_EQ(out_, kNew);
  EXPECT_EQ(err_, "");
  EXPECT_EQ(Read(file), kOld);
}

TEST_F(UpgradeTest, WritesInPlace) {
  const std::string a = Write("a.xml", kOld);
  const std::string b = Write("b.xml", kNew);
  EXPECT_EQ(Run(RunUpgrade, {a, b, "-i"}), 0) << err_;
  EXPECT_EQ(out_, "");
  EXPECT_EQ(Read(a), kNew);
  EXPECT_EQ(Read(b), kNew);
}

TEST_F(UpgradeTest, WritesToAnotherFile) {
  const std::string file = Write("t.xml", kOld);
  EXPECT_EQ(Run(RunUpgrade, {file, "-o", file + ".new"}), 0) << err_;
  EXPECT_EQ(Read(file + ".new"), kNew);
  EXPECT_EQ(Read(file), kOld);
}

TEST_F(UpgradeTest, WhatIsATreeOfAnotherFileBecomesASubTree) {
  Write("b.xml", "<root><BehaviorTree ID='B'><A/></BehaviorTree></root>");
  const std::string file = Write(
      "t.xml", "<root><include path='b.xml'/><BehaviorTree ID='M'><B/></BehaviorTree></root>");
  EXPECT_EQ(Run(RunUpgrade, {file}), 0) << err_;
  EXPECT_NE(out_.find("<SubTree ID=\"B\"/>"), std::string::npos) << out_;
}

TEST_F(UpgradeTest, ANodeThatHasTheNameOfATreeStaysANode) {
  Write("b.xml",
        "<root><BehaviorTree ID='B'><A/></BehaviorTree>"
        "<TreeNodesModel><Action ID='B'/></TreeNodesModel></root>");
  const std::string file = Write(
      "t.xml", "<root><include path='b.xml'/><BehaviorTree ID='M'><B/></BehaviorTree></root>");
  EXPECT_EQ(Run(RunUpgrade, {file}), 0) << err_;
  EXPECT_NE(out_.find("<B/>"), std::string::npos) << out_;
}

TEST_F(UpgradeTest, SaysWhatItCannotUpgradeAtItsPlaceInTheOldFile) {
  const std::string file =
      Write("t.xml",
            "<root>\n<BehaviorTree ID='M'>\n<A x='&&'/> <SubTree ID='T' a='0.5'/>\n"
            "</BehaviorTree></root>");
  EXPECT_EQ(Run(RunUpgrade, {file, "-i"}), 0);
  EXPECT_NE(err_.find(file + ":3:32: warning: \"0.5\" is no name for a key"), std::string::npos)
      << err_;
}

TEST_F(UpgradeTest, AMalformedFileIsLeftAlone) {
  const std::string file = Write("t.xml", "<root>");
  const std::string good = Write("good.xml", kOld);
  EXPECT_EQ(Run(RunUpgrade, {file, good, "-i"}), 2);
  EXPECT_NE(err_.find("<root> is never closed"), std::string::npos) << err_;
  EXPECT_EQ(Read(file), "<root>");
  EXPECT_EQ(Read(good), kNew) << "the others are done";
}

TEST_F(UpgradeTest, WrongUsageIsTwo) {
  EXPECT_EQ(Run(RunUpgrade, {}), 2);
  EXPECT_EQ(Run(RunUpgrade, {"a.xml", "-i", "-o", "b.xml"}), 2);
  EXPECT_EQ(Run(RunUpgrade, {"a.xml", "b.xml", "-o", "c.xml"}), 2);
}

}  // namespace
}  // namespace coppice
