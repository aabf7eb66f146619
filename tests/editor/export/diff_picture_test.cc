#include "editor/export/diff_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/editor/export/painted.h"
#include "tests/editor/shared_fonts.h"

namespace coppice::editor {
namespace {

TreeComparison Comparison(const Scene& before, const Scene& after) {
  return {"T", before, after, DiffTrees(before, after)};
}

TEST(DiffPicture, ShowsTreesThatDifferAndOnlyThese) {
  const auto a = MakeScene("<A><B/></A>");
  const auto b = MakeScene("<A><B/><C/></A>");
  const std::vector<TreeComparison> trees = {Comparison(*a, *a), Comparison(*a, *b)};
  const DiffPicture picture(trees);
  TreePainting painting;
  picture.AddTo(painting);
  ASSERT_EQ(painting.trees.size(), 1U);
  EXPECT_EQ(painting.trees[0].title, "T: 1 added");
  EXPECT_EQ(painting.trees[0].scene->nodes.size(), 3U);
}

TEST(DiffPicture, MarksEachKindOfChange) {
  const auto a = MakeScene("<A><B/><C n='1'/><D/><E/></A>");
  const auto b = MakeScene("<A><E/><C n='2'/><D/><F><G/></F></A>");
  const std::vector<TreeComparison> trees = {Comparison(*a, *b)};
  const DiffPicture picture(trees);
  TreePainting painting;
  picture.AddTo(painting);
  PictureMaker maker(1, SharedFonts(1));
  const Drawing drawing = maker.Draw(painting);
  for (const char* sign : {"+", "\u2013", "~", "1 \u2192 2"}) {
    EXPECT_TRUE(std::any_of(drawing.items.begin(), drawing.items.end(), [&](const DrawnItem& item) {
      return item.text == sign;
    })) << sign;
  }
}

}  // namespace
}  // namespace coppice::editor
