#include "bt_core/nodes/switch.h"

#include <gtest/gtest.h>

#include "bt_core/data/enum.h"

enum class Color { RED = 1, GREEN = 2 };
COPPICE_ENUM(Color, RED, GREEN)

namespace coppice {
namespace {

bool MatchesText(const Value& value, std::string_view text) {
  static const ScriptConstants constants = {{"LOW", 1}, {"HIGH", 2}};
  return MatchesText(value, text, constants);
}

TEST(MatchesText, ComparesStringsAsTheyAre) {
  EXPECT_TRUE(MatchesText(Value(std::string("red")), "red"));
  EXPECT_FALSE(MatchesText(Value(std::string("red")), "Red"));
  EXPECT_FALSE(MatchesText(Value(std::string("red")), "red "));
  EXPECT_TRUE(MatchesText(Value(std::string()), ""));
}

TEST(MatchesText, ComparesNumbersByValueWhateverTheirType) {
  EXPECT_TRUE(MatchesText(Value(std::string("1")), "1.0"));
  EXPECT_TRUE(MatchesText(Value(1), "1"));
  EXPECT_TRUE(MatchesText(Value(std::int64_t{-7}), "-7.00"));
  EXPECT_TRUE(MatchesText(Value(2U), "2"));
  EXPECT_TRUE(MatchesText(Value(std::uint64_t{9}), "9"));
  EXPECT_TRUE(MatchesText(Value(0.5), "0.50"));
  EXPECT_FALSE(MatchesText(Value(1), "2"));
  EXPECT_FALSE(MatchesText(Value(1), "one"));
  EXPECT_FALSE(MatchesText(Value(std::string("one")), "1"));
}

TEST(MatchesText, ToleratesTheEpsilonOfFloat) {
  EXPECT_TRUE(MatchesText(Value(0.3), "0.30000001"));
  EXPECT_FALSE(MatchesText(Value(0.3), "0.300001"));
}

TEST(MatchesText, TakesTrueForOneAndForTrue) {
  EXPECT_TRUE(MatchesText(Value(true), "1"));
  EXPECT_TRUE(MatchesText(Value(true), "true"));
  EXPECT_TRUE(MatchesText(Value(false), "0"));
  EXPECT_FALSE(MatchesText(Value(false), "true"));
  EXPECT_FALSE(MatchesText(Value(true), "2"));
}

TEST(MatchesText, KnowsTheNamesThatScriptsKnow) {
  EXPECT_TRUE(MatchesText(Value(2), "HIGH"));
  EXPECT_TRUE(MatchesText(Value(std::string("LOW")), "1"));
  EXPECT_TRUE(MatchesText(Value(std::string("LOW")), "LOW"));
  EXPECT_FALSE(MatchesText(Value(2), "LOW"));
}

TEST(MatchesText, ComparesEnumsByNameAndNumber) {
  EXPECT_TRUE(MatchesText(Value(Color::RED), "RED"));
  EXPECT_TRUE(MatchesText(Value(Color::RED), "1"));
  EXPECT_FALSE(MatchesText(Value(Color::RED), "GREEN"));
  EXPECT_FALSE(MatchesText(Value(Color::RED), "BLUE"));
}

}  // namespace
}  // namespace coppice
