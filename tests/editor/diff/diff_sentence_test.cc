#include "editor/diff/diff_sentence.h"

#include <gtest/gtest.h>

#include "tests/editor/canvas/make_scene.h"

namespace coppice::editor {
namespace {

struct Case {
  const char* before;
  const char* after;
  const char* sentence;
};

class DiffSentence : public testing::TestWithParam<Case> {};

TEST_P(DiffSentence, SaysInEnglishWhatDiffers) {
  const auto before = MakeScene(GetParam().before);
  const auto after = MakeScene(GetParam().after);
  const std::vector<NodeDiff> diffs = DiffTrees(*before, *after);
  ASSERT_EQ(diffs.size(), 1U);
  EXPECT_EQ(Sentence(diffs[0], *before, *after), GetParam().sentence);
}

INSTANTIATE_TEST_SUITE_P(
    All, DiffSentence,
    testing::Values(Case{"<A><B/></A>", "<A><B/><C/></A>", R"("C" was added below "A")"},
                    Case{"<A/>", "<B><A/></B>", R"("B" was added as the root)"},
                    Case{"<A><B/><C/></A>", "<A><B/></A>", R"("C" was removed; it was below "A")"},
                    Case{"<A><B/><C/></A>", "<A><C/><B/></A>",
                         R"("B" was moved from place 1 to place 2 below "A")"},
                    Case{"<A><B><C/></B><D/></A>", "<A><B/><D><C/></D></A>",
                         R"("C" was moved from below "B" to below "D")"},
                    Case{"<A><B x='3'/></A>", "<A><B x='5'/></A>",
                         R"("B" has changed: x was "3" and is now "5")"},
                    Case{"<A><B/></A>", "<A><B x='5'/></A>",
                         R"("B" has changed: x is now "5" and was not set before)"},
                    Case{"<A><B x='3'/></A>", "<A><B/></A>",
                         R"("B" has changed: x was "3" and is no longer set)"}));

}  // namespace
}  // namespace coppice::editor
