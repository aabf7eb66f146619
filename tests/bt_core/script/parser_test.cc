#include "bt_core/script/parser.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bt_core/script/grammar.h"

namespace coppice::script {
namespace {

std::string Show(const Ast& ast, NodeId id) {
  const Node& node = ast.nodes[id];
  if (node.op == Operator::kName) return std::string(node.name);
  if (node.op == Operator::kLiteral) return Describe(node.value);
  std::string text = "(";
  if (node.op != Operator::kCompare) text += std::string(SymbolOf(node.op)) + " ";
  for (std::size_t i = 0; i < node.operands.size(); ++i) {
    if (i > 0) text += node.relations.empty() ? " " : ToString(node.relations[i - 1]);
    text += Show(ast, node.operands[i]);
  }
  return text + ")";
}

// The statements as nested lists, or the first problem as "offset: message (hint)".
std::string Parsed(std::string_view script) {
  std::vector<ScriptProblem> problems;
  const Ast ast = Parse(script, problems);
  std::string text;
  for (const ScriptProblem& problem : problems) {
    if (!text.empty()) text += " | ";
    text += std::to_string(problem.offset) + ": " + problem.message;
    if (!problem.hint.empty()) text += " (" + problem.hint + ")";
  }
  if (!problems.empty()) return text;
  for (const NodeId statement : ast.statements) text += Show(ast, statement);
  return text;
}

TEST(Parse, BindsByPrecedence) {
  EXPECT_EQ(Parsed("a || b && c == d | e & f + g * -h"),
            "(|| a (&& b (c==(| d (& e (+ f (* g (- h))))))))");
  EXPECT_EQ(Parsed("-a * b + c & d | e == f && g || h"),
            "(|| (&& ((| (& (+ (* (- a) b) c) d) e)==f) g) h)");
  EXPECT_EQ(Parsed("(a || b) && c"), "(&& (|| a b) c)");
  EXPECT_EQ(Parsed("a | b ^ c | d"), "(| (^ (| a b) c) d)");
  EXPECT_EQ(Parsed("'a' .. b + c"), "(+ (.. 'a' b) c)");
  EXPECT_EQ(Parsed("!a == b"), "((! a)==b)");
}

TEST(Parse, TakesTheLeftOfEqualsFirst) {
  EXPECT_EQ(Parsed("a - b - c"), "(- (- a b) c)");
  EXPECT_EQ(Parsed("a / b * c % d"), "(% (* (/ a b) c) d)");
}

TEST(Parse, AssignmentsAndChoicesTakeTheRightFirst) {
  EXPECT_EQ(Parsed("a := b = c += 1"), "(:= a (= b (+= c 1)))");
  EXPECT_EQ(Parsed("a ? b : c ? d : e"), "(?: a b (?: c d e))");
  EXPECT_EQ(Parsed("a ? b ? 1 : 2 : 3"), "(?: a (?: b 1 2) 3)");
  EXPECT_EQ(Parsed("x := a > 1 ? 'y' : 'n'"), "(:= x (?: (a>1) 'y' 'n'))");
  EXPECT_EQ(Parsed("a ? x := 1 : y := 2"), "(?: a (:= x 1) (:= y 2))");
}

TEST(Parse, ComparisonsMakeAChain) {
  EXPECT_EQ(Parsed("a < b <= c != d"), "(a<b<=c!=d)");
  EXPECT_EQ(Parsed("(a < b) < c"), "((a<b)<c)");
}

TEST(Parse, NumbersHaveTheirFullRange) {
  EXPECT_EQ(Parsed("-9223372036854775808"), "-9223372036854775808");
  EXPECT_EQ(Parsed("0x7FFFFFFFFFFFFFFF"), "9223372036854775807");
  EXPECT_EQ(Parsed("-0x10"), "-16");
  EXPECT_EQ(Parsed("9223372036854775808"),
            "0: 9223372036854775808 does not fit in 64 bits (write 9223372036854775808.0 for a "
            "double)");
  EXPECT_EQ(Parsed("1.5e-3"), "0.0015");
  EXPECT_EQ(Parsed("1e999"), "0: 1e999 is too large for a double");
}

TEST(Parse, SemicolonsMayBeLeftOutBetweenAssignments) {
  EXPECT_EQ(Parsed("a := 1; b := 2;"), "(:= a 1)(:= b 2)");
  EXPECT_EQ(Parsed("a := 1 b := 2\n c += 3"), "(:= a 1)(:= b 2)(+= c 3)");
  EXPECT_EQ(Parsed(";; a ;;"), "a");
  EXPECT_EQ(Parsed("a b := 2"),
            R"(2: expected an operator or ";" before "b" (statements are separated by ";"))");
}

TEST(Parse, SaysWhatWasExpected) {
  EXPECT_EQ(Parsed(""), "0: the script is empty");
  EXPECT_EQ(Parsed(" ; "), "3: the script is empty");
  EXPECT_EQ(Parsed("a and b"), R"(2: expected an operator or ";" before "and" (write &&))");
  EXPECT_EQ(Parsed("a == = b"), R"(5: expected a value after "==", not "=" (write == to compare))");
  EXPECT_EQ(Parsed("a +"), R"(3: expected a value after "+")");
  EXPECT_EQ(Parsed("(a + b"), "6: expected \")\"");
  EXPECT_EQ(Parsed("(a b)"), "3: expected an operator or \")\" before \"b\"");
  EXPECT_EQ(Parsed("a ? b"), R"(5: expected ":" and the other choice (condition ? a : b))");
  EXPECT_EQ(Parsed("a + b = 5"), "6: only a key can be assigned to (write == to compare)");
  EXPECT_EQ(Parsed("5 := a"),
            R"(2: only a key can be assigned to (on the left of ":=" stands the name of a key))");
  EXPECT_EQ(Parsed("mni(1, 2)"), R"(0: unknown function "mni" (did you mean "min"?))");
  EXPECT_EQ(Parsed("sqrt(2)"),
            R"(0: unknown function "sqrt" (the functions are abs, clamp, max and min))");
  EXPECT_EQ(Parsed("1 + min(1)"), R"(4: "min" takes 2 or more values, not 1)");
  EXPECT_EQ(Parsed("clamp(1, 2, 3, 4)"), R"(0: "clamp" takes 3 values, not 4)");
  EXPECT_EQ(Parsed("abs()"), R"(0: "abs" takes 1 values, not 0)");
}

TEST(Parse, GoesOnBehindTheSemicolon) {
  EXPECT_EQ(Parsed("1 = 2; a := 5; ) ; (c"),
            "2: only a key can be assigned to (write == to compare) | 15: expected a value, not "
            "\")\" | 21: expected \")\"");
}

TEST(Parse, BoundsDepthAndLength) {
  const auto nested = [](int levels) {
    return std::string(levels, '(') + "a" + std::string(levels, ')');
  };
  EXPECT_EQ(Parsed(nested(kMaxDepth - 1)), "a");
  EXPECT_EQ(Parsed(nested(kMaxDepth)).substr(0, 35), "100: the script is nested too deepl");
  std::string sum = "a";
  for (int i = 0; i < kMaxOperators - 1; ++i) sum += "+a";
  EXPECT_EQ(Parsed(sum).front(), '(');
  EXPECT_NE(Parsed(sum + "+a").find("too many operators"), std::string::npos);
}

}  // namespace
}  // namespace coppice::script
