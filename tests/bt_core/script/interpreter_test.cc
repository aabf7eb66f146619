#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/data/standard_types.h"
#include "bt_core/script/code.h"
#include "tests/bt_core/script/fixture.h"

namespace coppice {
namespace {

std::string ErrorOf(ScriptBench& bench, std::string_view script) {
  try {
    bench.Run(script);
  } catch (const ScriptError& error) {
    return error.what();
  }
  return {};
}

TEST(Interpreter, ATextThatJoinsItselfComesToAnEnd) {
  ScriptBench bench;
  bench.Set("s", std::string(600000, 'x'));
  EXPECT_NE(
      ErrorOf(bench, "s .. s").find("a text of 1200000 bytes; scripts join texts up to 1048576"),
      std::string::npos);
  EXPECT_EQ(ErrorOf(bench, "s .. 'x'"), "");
}

TEST(Interpreter, EveryOperatorGivesItsResult) {
  const std::pair<const char*, const char*> kCases[] = {
      {"7 + i", "int64 10"},
      {"i - 7", "int64 -4"},
      {"i * 2.5", "double 7.5"},
      {"i / 2", "double 1.5"},
      {"7 % i", "int64 1"},
      {"-i", "int64 -3"},
      {"~i", "int64 -4"},
      {"!i", "bool false"},
      {"i & 6", "int64 2"},
      {"i | 4", "int64 7"},
      {"i ^ 1", "int64 2"},
      {"i .. 'x'", "string 3x"},
      {"'x' .. 2.0", "string x2"},
      {"s + s", "string abab"},
      {"b .. i", "string true3"},
      {"i < 4", "bool true"},
      {"i == 3 == true", "bool false"},
      {"(i == 3) == true", "bool true"},
      {"1 < i <= 3", "bool true"},
      {"i ? s : 0", "string ab"},
      {"!s0 ? 1 : 2", "int64 1"},
      {"b && i", "bool true"},
      {"!b || !i", "bool false"},
      {"min(i, 2, 2.5)", "int64 2"},
      {"max(i, 3.5)", "double 3.5"},
      {"abs(-i)", "int64 3"},
      {"clamp(i, 0, 1.5)", "double 1.5"},
      {"f", "double 0.5"},
      {"u .. ''", "string 7"},
      {"list .. ';3'", "string 1;2;3"},
  };
  ScriptBench bench;
  bench.Set("i", std::int64_t{3});
  bench.Set("s", std::string("ab"));
  bench.Set("s0", std::string("0"));
  bench.Set("b", true);
  bench.Set("f", 0.5F);
  bench.Set("u", 7U);
  bench.Set("list", std::vector<int>{1, 2});
  for (const auto& [script, result] : kCases) EXPECT_EQ(bench.ResultOf(script), result) << script;
}

TEST(Interpreter, ErrorsNameThePlace) {
  ScriptBench bench;
  bench.Set("s", std::string("ab"));
  EXPECT_EQ(ErrorOf(bench, "s + missing"),
            R"(script "s + missing", at character 5, key "missing": it has no value yet)");
  EXPECT_EQ(ErrorOf(bench, "1; s * 2"),
            R"(script "1; s * 2", at character 6: 'ab' is not a number)");
  EXPECT_EQ(ErrorOf(bench, "s + 1 * 2"),
            "script \"s + 1 * 2\", at character 3: + adds two numbers or joins two texts; .. joins "
            "'ab' and 2");
  EXPECT_EQ(ErrorOf(bench, "@fresh = 1"),
            R"(script "@fresh = 1", at character 1, key "@fresh": it has no value yet; := creates )"
            "it");
  EXPECT_EQ(ErrorOf(bench, "s := 5 + 1"),
            R"(script "s := 5 + 1", at character 1, key "s": 6 is no value of type string)");
  EXPECT_EQ(ErrorOf(bench, "x := s < 5"),
            R"(script "x := s < 5", at character 6, key "s": "<" has no meaning between 'ab' and )"
            "5");
}

TEST(Interpreter, LongTextsAreJoinedToo) {
  ScriptBench bench;
  const std::string part(300, 'p');
  bench.Set("part", part);
  bench.Run("all := part .. part .. 'x' .. part .. part .. 1");
  EXPECT_EQ(bench.Show("all"), "string " + part + part + "x" + part + part + "1");
}

TEST(Interpreter, KeysAreNamedAsTheyAreWritten) {
  EXPECT_EQ(script::KeyAt("a + @key_1 > 2", 4), "@key_1");
  EXPECT_EQ(script::KeyAt("key", 0), "key");
}

}  // namespace
}  // namespace coppice
