#include "robot_app/processes/config/variables.h"

#include <gmock/gmock.h>

#include <vector>

namespace coppice::robot::processes {
namespace {

using testing::ElementsAre;

class VariablesTest : public testing::Test {
 protected:
  std::string Fill(const std::string& text) {
    return FillVariables(text, {{"bin", "/b"}, {"empty", ""}}, advisor_,
                         [this](const std::string& message, const std::string& hint) {
                           problems_.push_back(message + "|" + hint);
                         });
  }
  Advisor advisor_;
  std::vector<std::string> problems_;
};

TEST_F(VariablesTest, AreFilledInWithDefaultsThatMayHoldVariables) {
  EXPECT_EQ(Fill("${bin}/x ${bin}"), "/b/x /b");
  EXPECT_EQ(Fill("a${empty}b"), "ab");
  EXPECT_EQ(Fill("${none:-${bin}/${other:-7}}"), "/b/7");
  EXPECT_EQ(Fill("$bin {bin}"), "$bin {bin}");
  EXPECT_TRUE(problems_.empty());
}

TEST_F(VariablesTest, ThatHaveNoValueAreReportedWithTheNearestName) {
  EXPECT_EQ(Fill("x${bim}y"), "xy");
  EXPECT_EQ(Fill("${speed}"), "");
  EXPECT_EQ(Fill("a${bin"), "a");
  EXPECT_THAT(problems_, ElementsAre(R"(variable "bim" has no value|did you mean "bin"?)",
                                     R"(variable "speed" has no value|give it with --set )"
                                     "speed=VALUE",
                                     R"("${" without "}" in "a${bin"|)"));
}

// 60 kB of them took half a gigabyte.
TEST_F(VariablesTest, DefaultsWithinDefaultsWithoutEndStandForNothing) {
  std::string nested = "x";
  for (int i = 0; i < 16; ++i) nested = "${none:-" + nested + "}";
  EXPECT_EQ(Fill(nested), "x");
  EXPECT_EQ(Fill("a${none:-" + nested + "}b"), "ab");
  EXPECT_THAT(problems_, ElementsAre("more than 16 defaults within each other|"));
}

TEST_F(VariablesTest, ATextThatWouldBeTooLongStandsForNothing) {
  std::string many;
  for (std::size_t i = 0; i <= kLongestFilled; ++i) many += "${bin}";
  EXPECT_EQ(Fill(many), "");
  EXPECT_THAT(problems_, ElementsAre("stands for more than 65536 bytes|"));
}

}  // namespace
}  // namespace coppice::robot::processes
