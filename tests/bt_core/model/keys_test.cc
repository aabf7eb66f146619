#include "bt_core/model/keys.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

TEST(KeyOf, TellsKeysFromLiterals) {
  EXPECT_EQ(KeyOf("{goal}", "port"), "goal");
  EXPECT_EQ(KeyOf("  {goal} ", "port"), "goal");
  EXPECT_EQ(KeyOf("{@goal}", "port"), "@goal");
  EXPECT_EQ(KeyOf("{ goal }", "port"), "goal");
  for (const char* literal :
       {"", " ", "goal", "{goal", "goal}", "{", "{}", "{@}", "a{b}", "{a}_{b}"}) {
    EXPECT_EQ(KeyOf(literal, "port"), "") << literal;
  }
}

TEST(KeyOf, EqualsSignIsTheOwnName) {
  EXPECT_EQ(KeyOf("=", "port"), "port");
  EXPECT_EQ(KeyOf("{=}", "port"), "port");
}

bool Autoremaps(const std::string& attribute) {
  Diagnostics diagnostics;
  const auto document = Document::FromText("<SubTree " + attribute + "/>", "f.xml", diagnostics);
  return IsAutoremapped(*document, document->element(kRootElement));
}

TEST(IsAutoremapped, TakesEveryTrueValueOfABool) {
  for (const char* yes : {"true", "True", "TRUE", "1"}) {
    EXPECT_TRUE(Autoremaps("_autoremap='" + std::string(yes) + "'")) << yes;
  }
  for (const char* no : {"false", "0", "", "yes"}) {
    EXPECT_FALSE(Autoremaps("_autoremap='" + std::string(no) + "'")) << no;
  }
  EXPECT_FALSE(Autoremaps("name='S'"));
}

TEST(IsPrivateKey, IsOneWithAnUnderscoreInFront) {
  EXPECT_TRUE(IsPrivateKey("_mine"));
  EXPECT_FALSE(IsPrivateKey("not_mine"));
}

}  // namespace
}  // namespace coppice
