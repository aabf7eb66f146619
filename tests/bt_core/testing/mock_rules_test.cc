#include "bt_core/testing/mock_rules.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

const NodeNames kDrive{"drive", "patrol/round/drive", "DriveTo"};

TEST(MockRules, APatternIsAName) {
  EXPECT_TRUE(Matches("drive", kDrive));
  EXPECT_TRUE(Matches("dr*", kDrive));
  EXPECT_FALSE(Matches("DriveTo", kDrive));
  EXPECT_FALSE(Matches("driver", kDrive));
}

TEST(MockRules, WithASlashItIsAPath) {
  EXPECT_TRUE(Matches("patrol/round/drive", kDrive));
  EXPECT_TRUE(Matches("/patrol/*", kDrive));
  EXPECT_TRUE(Matches("*/drive", kDrive));
  EXPECT_FALSE(Matches("round/drive", kDrive));
  EXPECT_FALSE(Matches("/drive", kDrive));
  EXPECT_TRUE(Matches("/drive", {"drive", "drive", "DriveTo"}));
}

TEST(MockRules, InAngleBracketsItIsAType) {
  EXPECT_TRUE(Matches("<DriveTo>", kDrive));
  EXPECT_TRUE(Matches("<*>", kDrive));
  EXPECT_FALSE(Matches("<drive>", kDrive));
}

TEST(MockRules, AStarStandsForAnyCharacters) {
  EXPECT_TRUE(FitsWildcards("*", ""));
  EXPECT_TRUE(FitsWildcards("a*b*c", "aXbYbZc"));
  EXPECT_TRUE(FitsWildcards("a**", "a"));
  EXPECT_FALSE(FitsWildcards("a*b", "aXbY"));
  EXPECT_FALSE(FitsWildcards("", "a"));
  EXPECT_TRUE(FitsWildcards("", ""));
}

TEST(MockRules, AWildcardPatternIsNotExponential) {
  EXPECT_FALSE(FitsWildcards("*a*a*a*a*a*a*a*a*a*a*a*a*b", std::string(2000, 'a')));
}

std::string Chosen(const std::vector<std::string>& patterns) {
  std::vector<MockRule> rules;
  for (const std::string& pattern : patterns) rules.push_back({pattern, {}});
  const auto chosen = ChooseRule(rules, kDrive);
  return chosen ? std::to_string(*chosen) + " " + rules[*chosen].pattern : "none";
}

TEST(MockRules, TheMostSpecificRuleDecides) {
  EXPECT_EQ(Chosen({"<DriveTo>", "dr*", "drive", "patrol/*"}), "3 patrol/*");
  EXPECT_EQ(Chosen({"<DriveTo>", "dr*", "drive"}), "2 drive");
  EXPECT_EQ(Chosen({"<DriveTo>", "d*", "dr*"}), "2 dr*");
  EXPECT_EQ(Chosen({"<*>", "<Drive*>", "<DriveTo>"}), "2 <DriveTo>");
}

TEST(MockRules, AmongEquallySpecificRulesTheFirstDecides) {
  EXPECT_EQ(Chosen({"*ive", "dri*", "*riv*"}), "0 *ive");
  EXPECT_EQ(Chosen({"drive", "drive"}), "0 drive");
}

TEST(MockRules, NoRuleMayFit) { EXPECT_EQ(Chosen({"<Wait>", "stop"}), "none"); }

}  // namespace
}  // namespace coppice
