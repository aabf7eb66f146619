#include "bt_core/script/grammar.h"

#include <gtest/gtest.h>

#include <string>

namespace coppice::script {
namespace {

Token Symbol(std::string_view text) { return {TokenKind::kSymbol, 0, text}; }
Token Word(std::string_view text) { return {TokenKind::kName, 0, text}; }

TEST(Grammar, OperatorsBindAsInTheTable) {
  const char* const kLooseToTight[] = {"||", "&&", "==", "|", "&", "+", "*"};
  int precedence = 0;
  for (const char* symbol : kLooseToTight) {
    const BinaryOperator* const found = FindBinary(Symbol(symbol));
    ASSERT_TRUE(found) << symbol;
    EXPECT_GT(found->precedence, precedence) << symbol;
    precedence = found->precedence;
  }
  EXPECT_EQ(FindBinary(Symbol("!")), nullptr);
  EXPECT_EQ(FindBinary(Word("and")), nullptr);
}

TEST(Grammar, ATextIsNoSymbol) {
  EXPECT_EQ(FindBinary({TokenKind::kText, 0, "+"}), nullptr);
  EXPECT_EQ(FindAssignment({TokenKind::kText, 0, "="}), nullptr);
}

TEST(Grammar, EveryOperatorHasASymbol) {
  EXPECT_EQ(SymbolOf(Operator::kAddTo), "+=");
  EXPECT_EQ(SymbolOf(Operator::kAnd), "&&");
  EXPECT_EQ(SymbolOf(Operator::kNot), "!");
  EXPECT_EQ(SymbolOf(Operator::kClamp), "clamp");
  EXPECT_EQ(SymbolOf(Operator::kChoose), "?:");
}

TEST(Grammar, KnowsItsFunctions) {
  for (const std::string& name : FunctionNames()) EXPECT_TRUE(FindFunction(name)) << name;
  EXPECT_EQ(FindFunction("sqrt"), nullptr);
}

TEST(Grammar, OperatorsOfOtherLanguagesGetAHint) {
  EXPECT_EQ(HintForForeignOperator(Word("a"), Word("and")), "write &&");
  EXPECT_EQ(HintForForeignOperator(Word("not"), Word("a")), R"(write ! for "not")");
  EXPECT_EQ(HintForForeignOperator(Symbol("<"), Symbol(">")), "write !=");
  EXPECT_EQ(HintForForeignOperator(Symbol("<"), Symbol("<")), "");
  EXPECT_EQ(HintForForeignOperator(Word("a"), Word("b")), "");
}

}  // namespace
}  // namespace coppice::script
