#include "editor/document/shown_problems.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

Diagnostic Unknown(const std::string& type, std::uint32_t line) {
  return {
      Severity::kWarning, {"t.xml", line, 5}, "as it is worded", "", {ProblemKind::kNoModel, type}};
}

TEST(ShownProblems, TypesWithoutAModelAreOneRemarkAtTheEnd) {
  const Diagnostic other{Severity::kError, {"t.xml", 9, 1}, "something else", "", {}};
  const auto shown = ShownProblems({Unknown("A", 3), Unknown("B", 4), other}, false);
  ASSERT_EQ(shown.size(), 2U);
  EXPECT_EQ(shown[0].message, "something else");
  EXPECT_EQ(shown[1].message, "2 types have no model, so their ports are not checked: A, B");
  EXPECT_EQ(shown[1].where.line, 3U);
  EXPECT_TRUE(IsAboutModels(shown[1]));
  EXPECT_FALSE(IsAboutModels(shown[0]));
}

TEST(ShownProblems, OneTypeIsNamed) {
  EXPECT_EQ(ShownProblems({Unknown("A", 3)}, false)[0].message,
            "type A has no model, so its ports are not checked");
}

TEST(ShownProblems, OfManyTypesSomeAreNamed) {
  std::vector<Diagnostic> problems;
  for (const char type : std::string("ABCDEFGHIJ")) problems.push_back(Unknown({type}, 1));
  EXPECT_EQ(ShownProblems(problems, false)[0].message,
            "10 types have no model, so their ports are not checked: A, B, C, D, E, F and 4 more");
}

TEST(ShownProblems, ANewFileIsNotBlamedForBeingEmpty) {
  const Diagnostic problem{
      Severity::kError, {"t.xml", 3, 3}, "as it is worded", "", {ProblemKind::kEmptyTree, "M"}};
  EXPECT_TRUE(ShownProblems({problem}, true).empty());
  EXPECT_EQ(ShownProblems({problem}, false).size(), 1U);
}

}  // namespace
}  // namespace coppice::editor
