#include <gmock/gmock.h>

#include "bt_core/model/element_edits.h"
#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;

TEST(Draft, FollowsElementsThroughEditsBeforeThem) {
  Draft draft = DraftOf(Parsed(kRound), {"C", "D"});
  ASSERT_TRUE(
      draft.Apply(InsertElement(draft.document(), Find(draft.document(), "top"), 0, "<New/>")));
  EXPECT_THAT(Selected(draft), ElementsAre("C", "D"));
}

TEST(Draft, ForgetsWhatIsGone) {
  Draft draft = DraftOf(Parsed(kRound), {"A", "D"});
  ASSERT_TRUE(draft.Apply(RemoveElement(draft.document(), Find(draft.document(), "inner"))));
  EXPECT_THAT(Selected(draft), ElementsAre("A"));
}

TEST(Draft, FollowsAnElementThatMoves) {
  Draft draft = DraftOf(Parsed(kRound), {"A"});
  ASSERT_TRUE(draft.Move(Find(draft.document(), "A"), Find(draft.document(), "inner"), 1));
  EXPECT_THAT(Selected(draft), ElementsAre("A"));
  EXPECT_EQ(PositionOf(draft.document(), draft.selection()[0]), 1U);
}

TEST(Draft, RefusesMalformedTextAndStaysAsItWas) {
  const Document document = Parsed(kRound);
  Draft draft(document);
  EXPECT_FALSE(draft.Apply(InsertElement(document, Find(document, "top"), 0, "<New>")));
  EXPECT_FALSE(draft.has_changed());
  EXPECT_EQ(draft.document().text(), kRound);
  EXPECT_TRUE(draft.problems().has_errors());
}

TEST(Topmost, LeavesOutWhatLiesInOthers) {
  const Document document = Parsed(kRound);
  const ElementIndex inner = Find(document, "inner");
  const ElementIndex a = Find(document, "A");
  EXPECT_THAT(Topmost(document, {Find(document, "D"), inner, a, a}), ElementsAre(a, inner));
}

}  // namespace
}  // namespace coppice::editor
