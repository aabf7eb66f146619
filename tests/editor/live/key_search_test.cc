#include "editor/live/key_search.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

TEST(KeySearch, FindsByPathAndByValueCapitalOrNot) {
  EXPECT_TRUE(IsKeyFound("Main/goal", "kitchen", "GOAL"));
  EXPECT_TRUE(IsKeyFound("Main/goal", "Kitchen", "main kitch"));
  EXPECT_FALSE(IsKeyFound("Main/goal", "kitchen", "main bath"));
}

TEST(KeySearch, NoWordsFindEverything) { EXPECT_TRUE(IsKeyFound("Main/goal", "", "  ")); }

TEST(KeySearch, ALargeValueIsCutAndSaysHowLargeItIs) {
  EXPECT_EQ(BeginningOf("abcdef", 6), "abcdef");
  EXPECT_EQ(BeginningOf("abcdefg", 3), "abc ... (7 bytes in all)");
}

TEST(KeySearch, NoCharacterIsCutIntoPieces) {
  EXPECT_EQ(BeginningOf("ab\u00e4cd", 3), "ab ... (6 bytes in all)");
}

}  // namespace
}  // namespace coppice::editor
