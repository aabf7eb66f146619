#include "editor/files/line_changes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace coppice::editor {
namespace {

// "." same, "+" added, "~" changed, "-" lines before it are gone.
std::string Marks(const std::string& before, const std::string& after) {
  std::string text;
  for (const LineMark mark : MarkLines(before, after)) text += ".+~-"[static_cast<int>(mark)];
  return text;
}

TEST(LineChanges, TheSameTextHasNoMarks) {
  EXPECT_EQ(Marks("a\nb\n", "a\nb\n"), "...");
  EXPECT_EQ(Marks("", ""), ".");
}

TEST(LineChanges, TellsAddedFromChangedLines) {
  EXPECT_EQ(Marks("a\nb\nc", "a\nx\nb\nc"), ".+..");
  EXPECT_EQ(Marks("a\nb\nc", "a\nx\nc"), ".~.");
  EXPECT_EQ(Marks("a\nb\nc\nd\ne", "a\nx\nc\nd\ny\ne"), ".~..+.");
}

TEST(LineChanges, MarksTheLineBehindRemovedOnes) {
  EXPECT_EQ(Marks("a\nb\nc", "a\nc"), ".-");
  EXPECT_EQ(Marks("a\nb\nc", "a\nb"), ".-") << "at the end the last one";
}

TEST(LineChanges, TextsWithNothingInCommonAreOneHunk) {
  std::string before;
  std::string after;
  for (int i = 0; i < 3000; ++i) {
    before += "a" + std::to_string(i) + "\n";
    after += "b" + std::to_string(i) + "\n";
  }
  ASSERT_EQ(CompareLines(before, after).size(), 1U);
  EXPECT_EQ(CompareLines(before, after)[0].after_end, 3000U);
}

TEST(LineChanges, TextsOfMillionsOfLinesAreTheSameOrOneHunk) {
  const std::string text(3'000'000, '\n');
  EXPECT_TRUE(CompareLines(text, text).empty());
  const auto hunks = CompareLines(text, text + "x");
  ASSERT_EQ(hunks.size(), 1U);
  EXPECT_EQ(hunks[0].before_end, 3'000'001U);
  EXPECT_EQ(hunks[0].after_end, 3'000'001U);
}

TEST(LineChanges, HunksTurnOneTextIntoTheOther) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    const auto text = [&] {
      std::string lines;
      for (unsigned i = random() % 12; i > 0; --i)
        lines += std::string(1, 'a' + random() % 4) + "\n";
      return lines;
    };
    const std::string before = text();
    const std::string after = text();
    std::string made;
    std::size_t line = 0;
    const auto copy = [&](const std::string& from, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        made += std::string(LinesOf(from, i, i + 1)) + "\n";
      }
    };
    for (const LineHunk& hunk : CompareLines(before, after)) {
      copy(before, line, hunk.before_begin);
      copy(after, hunk.after_begin, hunk.after_end);
      line = hunk.before_end;
    }
    const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    copy(before, line, lines + 1);
    EXPECT_EQ(made, after + "\n") << before << "->\n" << after;
  }
}

}  // namespace
}  // namespace coppice::editor
