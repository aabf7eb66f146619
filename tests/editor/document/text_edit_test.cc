#include "editor/document/text_edit.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

TEST(TextEdit, PutsAndErases) {
  TextEdit edit{"ab", 1, 1};
  edit.Put("xy");
  EXPECT_EQ(edit.text, "axyb");
  edit.Erase(false);
  EXPECT_EQ(edit.text, "axb");
  edit.Erase(true);
  EXPECT_EQ(edit.text, "ax");
  edit.Erase(true);
  EXPECT_EQ(edit.text, "ax");
  edit.SelectAll();
  EXPECT_EQ(edit.selected(), "ax");
  edit.Put("");
  edit.Erase(false);
  EXPECT_EQ(edit.text, "");
}

TEST(TextEdit, StepsOverWholeCharactersAndLineEnds) {
  TextEdit edit{"\xC3\xA9\r\nb", 0, 0};
  edit.Move(TextStep::kRight, false);
  EXPECT_EQ(edit.at, 2U);
  edit.Move(TextStep::kRight, false);
  EXPECT_EQ(edit.at, 4U);
  edit.Erase(false);
  edit.Erase(false);
  EXPECT_EQ(edit.text, "b");
}

TEST(TextEdit, KeepsTheColumnFromLineToLine) {
  TextEdit edit{"abcd\nx\nabcd", 3, 3};
  edit.Move(TextStep::kDown, false);
  EXPECT_EQ(edit.at, 6U);
  edit.Move(TextStep::kDown, false);
  EXPECT_EQ(edit.at, 8U);
  edit.Move(TextStep::kPageUp, false);
  EXPECT_EQ(edit.at, 1U);
  edit.Move(TextStep::kPageDown, false);
  EXPECT_EQ(edit.at, 8U);
}

TEST(TextEdit, GoesToTheFirstCharacterThenToTheStartOfTheLine) {
  TextEdit edit{"a\n  <b>\n", 6, 6};
  edit.Move(TextStep::kLineStart, false);
  EXPECT_EQ(edit.at, 4U);
  edit.Move(TextStep::kLineStart, false);
  EXPECT_EQ(edit.at, 2U);
  edit.Move(TextStep::kEnd, true);
  EXPECT_EQ(edit.selected(), "  <b>");
  edit.Move(TextStep::kLeft, false);
  EXPECT_EQ(edit.at, 2U);
  EXPECT_EQ(edit.anchor, 2U);
}

TEST(TextEdit, StepsOverWords) {
  TextEdit edit{R"(<a goal="x"/>)", 0, 0};
  edit.Move(TextStep::kWordRight, false);
  EXPECT_EQ(edit.at, 2U);
  edit.Move(TextStep::kWordRight, false);
  EXPECT_EQ(edit.at, 7U);
  edit.Move(TextStep::kWordLeft, true);
  EXPECT_EQ(edit.selected(), "goal");
}

TEST(TextEdit, ALineEndKeepsTheIndentation) {
  TextEdit edit{"<a>\r\n  <b/>", 11, 11};
  edit.PutLineEnd();
  EXPECT_EQ(edit.text, "<a>\r\n  <b/>\r\n  ");
}

TEST(TextEdit, StaysInTheText) {
  for (int step = 0; step <= static_cast<int>(TextStep::kTextEnd); ++step) {
    for (std::size_t at = 0; at <= 3; ++at) {
      TextEdit edit{"\na\n", at, at};
      edit.Move(static_cast<TextStep>(step), false);
      EXPECT_LE(edit.at, 3U);
      TextEdit empty;
      empty.Move(static_cast<TextStep>(step), false);
      EXPECT_EQ(empty.at, 0U);
    }
  }
}

}  // namespace
}  // namespace coppice::editor
