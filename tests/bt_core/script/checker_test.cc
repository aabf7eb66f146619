#include "bt_core/script/checker.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bt_core/data/standard_types.h"
#include "bt_core/script/parser.h"
#include "tests/bt_core/script/fixture.h"

namespace coppice::script {
namespace {

class CheckTest : public testing::Test {
 protected:
  CheckTest() {
    names_.Declare("number", &TypeOf<int>());
    names_.Declare("text", &TypeOf<std::string>());
    names_.Declare("list", &TypeOf<std::vector<int>>());
    names_.Declare("flag", &TypeOf<bool>());
    names_.Declare("any", nullptr);
  }

  // The first problem as "offset: message (hint)"; empty if there is none.
  std::string Problem(std::string_view script) {
    std::vector<ScriptProblem> problems;
    ast_ = Parse(script, problems);
    EXPECT_TRUE(problems.empty()) << script;
    Check(ast_, names_, {{"RED", 1}}, problems);
    if (problems.empty()) return {};
    const ScriptProblem& problem = problems[0];
    return std::to_string(problem.offset) + ": " + problem.message +
           (problem.hint.empty() ? "" : " (" + problem.hint + ")");
  }

  FlatNames names_;
  Ast ast_;
};

TEST_F(CheckTest, TakesWhatMayWork) {
  for (const char* good : {"any + 1",
                           "any + 'a'",
                           "any * any",
                           "!any",
                           "!text",
                           "text == number",
                           "text < any",
                           "number & 3.0",
                           "list == '1;2'",
                           "list == list",
                           "list != any",
                           "any := list",
                           "list := '1;2'",
                           "number := 5.0",
                           "number := '5'",
                           "number := any",
                           "text := text + 'a'",
                           "text += 'a'",
                           "any += 'a'",
                           "text := any",
                           "flag := 1",
                           "list .. text",
                           "RED + number",
                           "flag ? 1 : 'a'",
                           "min(any, 1, flag)",
                           "number == RED"}) {
    EXPECT_EQ(Problem(good), "") << good;
  }
}

TEST_F(CheckTest, RefusesWhatCannotWork) {
  const std::pair<const char*, const char*> kCases[] = {
      {"number + 'a'", "7: \"+\" takes numbers or two texts (\"..\" joins a text and a number)"},
      {"text * 2", "5: \"*\" takes numbers"},
      {"-text", "0: \"-\" takes numbers"},
      {"~2.5", "0: 2.5 is not a whole number"},
      {"1 & 0.5", "2: 0.5 is not a whole number"},
      {"abs('a')", "0: \"abs\" takes numbers"},
      {"list + 1", "5: \"+\" takes numbers or two texts (\"..\" joins a text and a number)"},
      {"!list", "1: \"list\" is neither true nor false (expected a bool or a number)"},
      {"flag && 'maybe'", "8: 'maybe' is neither true nor false"},
      {"list < 5", "5: \"list\", which is list of int, and 5 cannot be compared"},
      {"number == 'abc'", "10: 'abc' is no value of type int, which \"number\" has"},
      {"list == 'abc'", "8: 'abc' is no value of type list of int, which \"list\" has"},
      {"1 % 0", "2: 1 % 0 has no value"},
      {"clamp(1, 3, 2)", "0: clamp: the lower limit 3 is above the upper limit 2"},
      {"number := 2.5", "7: 2.5 is no value of type int"},
      {"flag := 2", "5: 2 is no value of type bool"},
      {"number := 'abc'", "10: 'abc' is no value of type int, which \"number\" has"},
      {"number := list", "7: a key of type int cannot take this value"},
      {"list := 5", "5: a key of type list of int cannot take this value"},
      {"text := list", "5: a key of type string cannot take this value"},
      {"text -= 'a'", "5: \"-=\" takes numbers"},
      {"text += 1",
       "5: \"+=\" takes numbers or two texts (key := key .. value joins a text and a number)"},
      {"list += any",
       "5: \"+=\" takes numbers or two texts (key := key .. value joins a text and a "
       "number)"},
      {"RED := 5",
       "0: \"RED\" is a constant and cannot be assigned to (give the key another name)"},
  };
  for (const auto& [script, problem] : kCases) EXPECT_EQ(Problem(script), problem) << script;
}

TEST_F(CheckTest, ComputesWhatIsKnown) {
  EXPECT_EQ(Problem("-(2 + 3) * 4 < any"), "");
  const Node& chain = ast_.nodes[ast_.statements[0]];
  const Node& left = ast_.nodes[chain.operands[0]];
  EXPECT_EQ(left.op, Operator::kLiteral);
  EXPECT_EQ(left.value.integer, -20);
}

TEST_F(CheckTest, ReportsEveryStatement) {
  std::vector<ScriptProblem> problems;
  Ast ast = Parse("text * 2; any := 1; !list; RED = 2", problems);
  Check(ast, names_, {{"RED", 1}}, problems);
  EXPECT_EQ(problems.size(), 3U);
}

}  // namespace
}  // namespace coppice::script
