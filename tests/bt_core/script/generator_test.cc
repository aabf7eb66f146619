#include "bt_core/script/generator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bt_core/script/checker.h"
#include "bt_core/script/parser.h"
#include "tests/bt_core/script/fixture.h"

namespace coppice::script {
namespace {

Code CodeOf(std::string_view script, std::vector<ScriptProblem>& problems) {
  FlatNames names;
  Ast ast = Parse(script, problems);
  Check(ast, names, {}, problems);
  EXPECT_TRUE(problems.empty()) << script;
  return Generate(std::move(ast), script, problems);
}

// The operations of Script::Test.
std::vector<Op> TestOf(std::string_view script) {
  std::vector<ScriptProblem> problems;
  const Code code = CodeOf(script, problems);
  std::vector<Op> ops;
  for (std::size_t i = code.test; i < code.instructions.size(); ++i) {
    ops.push_back(code.instructions[i].op);
  }
  return ops;
}

using Ops = std::vector<Op>;

TEST(Generate, AQuestionIsOneInstruction) {
  EXPECT_EQ(TestOf("battery < 7"), (Ops{Op::kIsLess, Op::kReturnFalse}));
  EXPECT_EQ(TestOf("7 < battery"), (Ops{Op::kIsGreater, Op::kReturnFalse}));
  EXPECT_EQ(TestOf("state == 'idle'"), (Ops{Op::kIsTextEqual, Op::kReturnFalse}));
  EXPECT_EQ(TestOf("!done"), (Ops{Op::kIsNotSlot, Op::kReturnFalse}));
  EXPECT_EQ(TestOf("a > 20 && !b && c"),
            (Ops{Op::kWhileGreater, Op::kWhileNotSlot, Op::kIsSlot, Op::kReturnFalse}));
}

TEST(Generate, ANumberThatNoDoubleIsGoesThroughARegister) {
  EXPECT_EQ(TestOf("a == 9007199254740993").front(), Op::kLoadSlot);
  EXPECT_EQ(TestOf("a == 9007199254740992").front(), Op::kIsEqual);
}

TEST(Generate, JumpsLeadForwardToAnInstruction) {
  std::vector<ScriptProblem> problems;
  const Code code =
      CodeOf("x := a ? b < c < d : !(e || f && g); h || (i ? j : k) && !(l == m)", problems);
  int jumps = 0;
  for (std::size_t i = 0; i < code.instructions.size(); ++i) {
    if (code.instructions[i].jump == 0) continue;
    ++jumps;
    EXPECT_LT(i + code.instructions[i].jump, code.instructions.size());
  }
  EXPECT_GT(jumps, 10);
  EXPECT_EQ(code.offsets.size(), code.instructions.size());
}

TEST(Generate, TextsAreCopiedOnlyNextToAnAssignment) {
  const Ops plain = TestOf("a := b .. c");
  const Ops nested = TestOf("x == b .. (c := 'd')");
  EXPECT_EQ(std::count(plain.begin(), plain.end(), Op::kLoadSlotCopy), 0);
  EXPECT_EQ(std::count(nested.begin(), nested.end(), Op::kLoadSlotCopy), 3);
}

TEST(Generate, RefusesAScriptThatNeedsTooManyRegisters) {
  std::string script = "a";
  for (int i = 0; i < 90; ++i) script = "a + b * (" + script + ")";
  std::vector<ScriptProblem> problems;
  CodeOf(script, problems);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].message, "this expression is nested too deeply");
}

TEST(Generate, ListsEverySlotOnce) {
  std::vector<ScriptProblem> problems;
  const Code code = CodeOf("a := b + b; a += c", problems);
  EXPECT_EQ(code.reads, (std::vector{SlotIndex{0}, SlotIndex{1}, SlotIndex{2}}));
  EXPECT_EQ(code.writes, std::vector{SlotIndex{0}});
}

}  // namespace
}  // namespace coppice::script
