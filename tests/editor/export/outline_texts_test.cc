#include "editor/export/outline_texts.h"

#include <gtest/gtest.h>

#include "tests/editor/canvas/make_scene.h"

namespace coppice::editor {
namespace {

TEST(OutlineTexts, MarkdownIsANestedList) {
  const auto scene =
      MakeScene("<Sequence><Retry name='again' n='3'><Open door='{door}'/></Retry></Sequence>");
  EXPECT_EQ(ToMarkdown({scene.get()}),
            "## T\n\n- Sequence\n  - again (Retry): n 3\n    - Open: door {door}\n");
}

TEST(OutlineTexts, MarkdownSaysNotesAndWhatIsDisabled) {
  const auto scene = MakeScene("<A><!-- why not --><B _skipIf='true' name='x_y'/></A>");
  const std::string text = ToMarkdown({scene.get()});
  EXPECT_NE(text.find("x\\_y (B)"), std::string::npos) << text;
  EXPECT_NE(text.find("(disabled)"), std::string::npos) << text;
  EXPECT_NE(text.find("*why not*"), std::string::npos) << text;
}

TEST(OutlineTexts, DotJoinsEachNodeToItsParent) {
  const auto scene = MakeScene(R"(<A><B x='say "hi"'/><C/></A>)");
  const std::string dot = ToDot({scene.get(), scene.get()});
  EXPECT_NE(dot.find("t0n0 -> t0n1;"), std::string::npos);
  EXPECT_NE(dot.find("t1n0 -> t1n2;"), std::string::npos);
  EXPECT_NE(dot.find("[label=\"B: x say \\\"hi\\\"\""), std::string::npos) << dot;
}

}  // namespace
}  // namespace coppice::editor
