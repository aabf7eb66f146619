#include "editor/files/change.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

TEST(Difference, IsTheSmallestSpliceThatMakesOneOfTheOther) {
  EXPECT_TRUE(Difference("abc", "abc").empty());
  for (const auto& [before, after] : {std::pair("abcd", "abXcd"), std::pair("aaa", "aaaa"),
                                      std::pair("", "a"), std::pair("abab", "ab")}) {
    const Edit edit = Difference(before, after);
    ASSERT_EQ(edit.size(), 1U);
    EXPECT_EQ(Apply(edit, before), after);
    EXPECT_LE(edit[0].removed + edit[0].inserted.size(), 2U) << before << " " << after;
  }
}

TEST(NamedChange, IsEmptyWithoutSteps) {
  NamedChange change{"Nothing", {{"a.xml", {}, {}, {}}}};
  EXPECT_TRUE(change.is_empty());
  change.files[0].steps.push_back({Replacement(0, 0, "x")});
  EXPECT_FALSE(change.is_empty());
}

}  // namespace
}  // namespace coppice::editor
