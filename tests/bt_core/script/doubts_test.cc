#include "bt_core/script/doubts.h"

#include <gtest/gtest.h>

#include "bt_core/script/parser.h"

namespace coppice::script {
namespace {

// "offset: message (hint)" of each.
std::string Doubts(const std::string& text) {
  std::vector<ScriptProblem> problems;
  const Ast ast = Parse(text, problems);
  EXPECT_TRUE(problems.empty());
  AddDoubts(ast, problems);
  std::string all;
  for (const ScriptProblem& problem : problems) {
    EXPECT_TRUE(problem.is_warning);
    all += std::to_string(problem.offset) + ": " + problem.message + " (" + problem.hint + ")\n";
  }
  return all;
}

TEST(Doubts, AnAssignmentInAConditionIsHardlyMeant) {
  EXPECT_EQ(Doubts("x = 3"), "2: this condition assigns to \"x\" (did you mean \"==\"?)\n");
  EXPECT_EQ(Doubts("!(ready = true)"),
            "8: this condition assigns to \"ready\" (did you mean \"==\"?)\n");
  EXPECT_EQ(Doubts("n += 1"), "2: this condition assigns to \"n\" ()\n");
}

TEST(Doubts, EachOneIsNamed) {
  EXPECT_EQ(Doubts("(a = 1) && (b := 2)"),
            "3: this condition assigns to \"a\" (did you mean \"==\"?)\n"
            "14: this condition assigns to \"b\" ()\n");
  EXPECT_EQ(Doubts("a ? b = 1 : (c = 2)"),
            "6: this condition assigns to \"b\" (did you mean \"==\"?)\n"
            "15: this condition assigns to \"c\" (did you mean \"==\"?)\n");
}

TEST(Doubts, AnAssignmentWhoseValueIsComparedIsMeant) {
  EXPECT_EQ(Doubts("(n += 1) > 3"), "");
  EXPECT_EQ(Doubts("ready && min(n -= 1, 5) == 0"), "");
}

TEST(Doubts, StatementsInFrontOfTheQuestionMayAssign) {
  EXPECT_EQ(Doubts("n = 3; n > 2"), "");
  EXPECT_EQ(Doubts("n += 1; n == 2 || n >= 5"), "");
}

}  // namespace
}  // namespace coppice::script
