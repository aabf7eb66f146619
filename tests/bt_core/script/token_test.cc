#include "bt_core/script/token.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace coppice::script {
namespace {

// The tokens with blanks between them; "!" stands for a problem.
std::string Tokens(std::string_view script) {
  std::vector<ScriptProblem> problems;
  std::string text;
  for (const Token& token : Tokenize(script, problems)) {
    if (token.kind == TokenKind::kEnd) break;
    if (!text.empty()) text += ' ';
    text += token.kind == TokenKind::kBad ? "!" : std::string(token.text);
  }
  return text;
}

TEST(Tokenize, TakesTheLongestSymbol) {
  EXPECT_EQ(Tokens("a:=b+=-1"), "a := b += - 1");
  EXPECT_EQ(Tokens("!a!=b&&c&d||e|f"), "! a != b && c & d || e | f");
  EXPECT_EQ(Tokens("a<=b<c==d"), "a <= b < c == d");
  EXPECT_EQ(Tokens("65..1"), "65 .. 1");
  EXPECT_EQ(Tokens("min(1,2)%3"), "min ( 1 , 2 ) % 3");
}

TEST(Tokenize, KnowsNumbersFromNames) {
  for (const char* good : {"0", "12", "0x1F", "0X1f", "1.5", "1e3", "1.5E-3", "007"}) {
    EXPECT_EQ(Tokens(good), good);
  }
  for (const char* bad :
       {"12abc", "65.", "65.x", "65.43foo", "0x", "0x1g", "0x1.5", "1e", "1e+", "1.5.2", "3_000"}) {
    EXPECT_EQ(Tokens(bad), "!") << bad;
  }
}

TEST(Tokenize, NamesMayBeginWithAnAt) {
  EXPECT_EQ(Tokens("@key _a b2 h\xC3\xA9"), "@key _a b2 h\xC3\xA9");
  EXPECT_EQ(Tokens("@ a@b"), "! a @b");
}

TEST(Tokenize, TextsStandInSingleOrDoubleQuotes) {
  EXPECT_EQ(Tokens(R"('a b' "c 'd'" 'e\'f')"), R"('a b' "c 'd'" 'e\'f')");
  EXPECT_EQ(Tokens("a 'never ends; b"), "a !");
  EXPECT_EQ(Tokens("'ends in a backslash\\"), "!");
}

TEST(Tokenize, BlanksSeparateAndNothingElse) {
  EXPECT_EQ(Tokens(" a\t\r\nb "), "a b");
  EXPECT_EQ(Tokens(std::string_view("a\0b", 3)), "a ! b");
  EXPECT_EQ(Tokens("a \\\n b \\\r\nc"), "a b c") << "a backslash may end a line";
  EXPECT_EQ(Tokens("a \\ b"), "a ! b");
  EXPECT_EQ(Tokens("a $ b # c"), "a ! b ! c");
  EXPECT_EQ(Tokens(""), "");
}

TEST(Tokenize, TellsWhereAndWhatToWrite) {
  std::vector<ScriptProblem> problems;
  Tokenize("a + {b} .5", problems);
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0].offset, 4U);
  EXPECT_EQ(problems[0].hint, "in a script a key is written without braces");
  EXPECT_EQ(problems[2].offset, 8U);
}

TEST(Unquote, KnowsFiveEscapes) {
  EXPECT_EQ(Unquote(R"('a\'b\\c\n\t\"')"), "a'b\\c\n\t\"");
  EXPECT_EQ(Unquote(R"('C:\data\d')"), "C:\\data\\d") << "other backslashes are themselves";
  EXPECT_EQ(Unquote("''"), "");
}

}  // namespace
}  // namespace coppice::script
