#include "editor/document/tree_edits.h"

#include <gmock/gmock.h>

#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class TreeEditsTest : public testing::Test {
 protected:
  TreeEditsTest() { models_.AddFrom(document_); }

  Draft Select(const std::vector<std::string>& names) { return DraftOf(document_, names); }

  // The text with one part replaced.
  static std::string With(const std::string& what, const std::string& by) {
    std::string text = kRound;
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
  }

  const Document document_ = Parsed(kRound);
  NodeModels models_;
  const NodeRules rules_{models_};
};

TEST_F(TreeEditsTest, InsertPutsNodesInAndSelectsThem) {
  Draft draft = Select({});
  EXPECT_EQ(InsertNodes(draft, rules_, Find(document_, "inner"), 1, {"<X/>", "<Y/>"}).problem(),
            "");
  EXPECT_EQ(draft.document().text(), With("<C msec='5'/>\n",
                                          "<C msec='5'/>\n        <X/>\n"
                                          "        <Y/>\n"));
  EXPECT_THAT(Selected(draft), ElementsAre("X", "Y"));
}

TEST_F(TreeEditsTest, ALeafTakesNoChildren) {
  Draft draft = Select({});
  EXPECT_EQ(InsertNodes(draft, rules_, Find(document_, "A"), 0, {"<X/>"}).problem(),
            "A takes no children");
  EXPECT_THAT(InsertNodes(draft, rules_, Find(document_, "BehaviorTree"), 0, {"<X/>"}).problem(),
              HasSubstr("one root node"));
  EXPECT_FALSE(draft.has_changed());
}

TEST_F(TreeEditsTest, DeleteTakesLinesAndSelectsTheNeighbour) {
  Draft draft = Select({"A", "C"});
  EXPECT_EQ(DeleteNodes(draft).problem(), "");
  EXPECT_THAT(draft.document().text(), Not(HasSubstr("<A/>")));
  EXPECT_THAT(draft.document().text(), HasSubstr("<!-- about B -->"));
  EXPECT_THAT(Selected(draft), ElementsAre("D"));
}

TEST_F(TreeEditsTest, DeleteOfTheLastChildSelectsTheOneBeforeOrTheParent) {
  Draft draft = Select({"D"});
  EXPECT_EQ(DeleteNodes(draft).problem(), "");
  EXPECT_THAT(Selected(draft), ElementsAre("C"));
  EXPECT_EQ(DeleteNodes(draft).problem(), "");
  EXPECT_THAT(Selected(draft), ElementsAre("inner"));
}

TEST_F(TreeEditsTest, DeleteKeepingChildrenPutsThemInItsPlace) {
  Draft draft = Select({"inner"});
  EXPECT_EQ(DeleteKeepingChildren(draft, rules_).problem(), "");
  EXPECT_THAT(draft.document().text(),
              HasSubstr("behind B -->\n      <C msec='5'/>\n      <D/>\n"));
  EXPECT_THAT(Selected(draft), ElementsAre("C"));
}

TEST_F(TreeEditsTest, TheRootWithSeveralChildrenCannotGoAlone) {
  Draft draft = Select({"top"});
  EXPECT_THAT(DeleteKeepingChildren(draft, rules_).problem(), HasSubstr("one root node"));
}

TEST_F(TreeEditsTest, MovesAmongSiblingsAndBack) {
  Draft draft = Select({"inner"});
  EXPECT_EQ(MoveAmongSiblings(draft, -1).problem(), "");
  EXPECT_THAT(Selected(draft), ElementsAre("inner"));
  EXPECT_EQ(PositionOf(draft.document(), draft.selection()[0]), 1U);
  EXPECT_EQ(MoveAmongSiblings(draft, +1).problem(), "");
  EXPECT_EQ(PositionOf(draft.document(), draft.selection()[0]), 2U);
  EXPECT_EQ(MoveAmongSiblings(draft, +1).problem(), "it is the last already");
}

TEST_F(TreeEditsTest, NeighboursMoveTogether) {
  Draft draft = Select({"A", "B"});
  EXPECT_EQ(MoveAmongSiblings(draft, +1).problem(), "");
  EXPECT_THAT(Selected(draft), ElementsAre("A", "B"));
  EXPECT_EQ(PositionOf(draft.document(), Find(draft.document(), "inner")), 0U);
  EXPECT_EQ(PositionOf(draft.document(), Find(draft.document(), "A")), 1U);
  EXPECT_FALSE(MoveAmongSiblings(draft, +1));
}

TEST_F(TreeEditsTest, PromoteGoesBehindTheParentAndDemoteIntoTheSiblingBefore) {
  Draft draft = Select({"C"});
  EXPECT_EQ(Promote(draft, rules_).problem(), "");
  EXPECT_EQ(PositionOf(draft.document(), draft.selection()[0]), 3U);
  EXPECT_EQ(Demote(draft, rules_).problem(), "");
  EXPECT_EQ(PositionOf(draft.document(), draft.selection()[0]), 1U);
  EXPECT_THAT(Selected(draft), ElementsAre("C"));
}

TEST_F(TreeEditsTest, DemoteGoesIntoTheNextSiblingIfTheOneBeforeTakesNone) {
  Draft draft = Select({"B"});
  EXPECT_EQ(Demote(draft, rules_).problem(), "");
  EXPECT_EQ(draft.document().element(Find(draft.document(), "inner")).child_count, 3U);
  EXPECT_EQ(PositionOf(draft.document(), draft.selection()[0]), 0U);
}

TEST_F(TreeEditsTest, ANodeDoesNotMoveIntoItself) {
  Draft draft = Select({"inner"});
  EXPECT_THAT(MoveInto(draft, rules_, Find(document_, "inner"), 0).problem(),
              HasSubstr("into itself"));
}

TEST_F(TreeEditsTest, SeveralNodesMoveInTheirOrder) {
  Draft draft = Select({"C", "A"});
  EXPECT_EQ(MoveInto(draft, rules_, Find(document_, "top"), 2).problem(), "");
  const Document& after = draft.document();
  EXPECT_THAT(Selected(draft), ElementsAre("A", "C"));
  EXPECT_EQ(PositionOf(after, Find(after, "B")), 0U);
  EXPECT_EQ(PositionOf(after, Find(after, "A")), 1U);
  EXPECT_EQ(PositionOf(after, Find(after, "C")), 2U);
}

TEST_F(TreeEditsTest, WrapPutsAnElementAroundNeighbours) {
  Draft draft = Select({"C", "D"});
  EXPECT_EQ(Wrap(draft, rules_, R"(<Parallel success_count="1"/>)").problem(), "");
  EXPECT_THAT(draft.document().text(),
              HasSubstr("        <Parallel success_count=\"1\">\n          <C msec='5'/>\n"));
  EXPECT_THAT(Selected(draft), ElementsAre("Parallel"));
  Draft far = Select({"A", "inner"});
  EXPECT_THAT(Wrap(far, rules_, "<Sequence/>").problem(), HasSubstr("only neighbours"));
  Draft two = Select({"C", "D"});
  EXPECT_EQ(Wrap(two, rules_, "<Inverter/>").problem(), "Inverter takes one child");
}

TEST_F(TreeEditsTest, ChangeTypeKeepsPortsThatBothHave) {
  Draft draft = Select({"B"});
  EXPECT_EQ(ChangeType(draft, rules_, "Go").problem(), "");
  EXPECT_EQ(draft.document().text(), With("<B goal", "<Go goal"));
  EXPECT_THAT(LostByChange(document_, rules_, Find(document_, "C"), "Go"), ElementsAre("msec"));
  EXPECT_THAT(LostByChange(document_, rules_, Find(document_, "C"), "Unheard"), IsEmpty());
  Draft control = Select({"inner"});
  EXPECT_EQ(ChangeType(control, rules_, "Go").problem(), "Go takes no children");
}

TEST_F(TreeEditsTest, DisableComesBackByteForByte) {
  Draft draft = Select({"B", "inner"});
  EXPECT_EQ(ToggleDisabled(draft).problem(), "");
  EXPECT_TRUE(IsDisabled(draft.document(), draft.selection()[0]));
  EXPECT_NE(draft.document().text(), kRound);
  EXPECT_EQ(ToggleDisabled(draft).problem(), "");
  EXPECT_EQ(draft.document().text(), kRound);
}

TEST_F(TreeEditsTest, ADisabledNodeKeepsItsOwnGuard) {
  const std::string text = R"(<root><BehaviorTree ID='M'><A _skipIf='a &lt; 3 && "x" == b' )"
                           "x='1'/></BehaviorTree></root>";
  Draft draft = DraftOf(Parsed(text), {"A"});
  EXPECT_EQ(ToggleDisabled(draft).problem(), "");
  EXPECT_THAT(draft.document().text(), HasSubstr(R"(_skipIf='true || (a &lt; 3 && "x" == b)')"));
  EXPECT_EQ(ToggleDisabled(draft).problem(), "");
  EXPECT_EQ(draft.document().text(), text);
}

TEST_F(TreeEditsTest, AnEmptyNameIsNoName) {
  Draft draft = Select({"inner"});
  EXPECT_EQ(SetValue(draft, "name", "").problem(), "");
  EXPECT_EQ(draft.document().text(), With(R"( name="inner")", ""));
  EXPECT_EQ(SetValue(draft, "name", "a < b").problem(), "");
  EXPECT_EQ(draft.document().text(), With(R"(name="inner")", R"(name="a &lt; b")"));
  EXPECT_FALSE(SetValue(draft, "no name", "x"));
}

}  // namespace
}  // namespace coppice::editor
