#include "editor/document/drop_edits.h"

#include <gmock/gmock.h>

#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;

class DropEditsTest : public testing::Test {
 protected:
  DropEditsTest() { models_.AddFrom(document_); }

  // The tags below the <BehaviorTree>: "Sequence(A B Fallback(C D))".
  static std::string Shape(const Draft& draft) {
    const Document& document = draft.document();
    return ShapeOf(document, document.element(Find(document, "BehaviorTree")).first_child);
  }
  static std::string ShapeOf(const Document& document, ElementIndex index) {
    std::string shape(document.element(index).tag);
    std::string children;
    for (ElementIndex c = document.element(index).first_child; c != kNoElement;
         c = document.element(c).next_sibling) {
      children += (children.empty() ? "" : " ") + ShapeOf(document, c);
    }
    return children.empty() ? shape : shape + "(" + children + ")";
  }

  const Document document_ = Parsed(kRound);
  NodeModels models_;
  const NodeRules rules_{models_};
};

TEST_F(DropEditsTest, CopiesLeaveWhatTheyWereMadeOf) {
  Draft draft = DraftOf(document_, {"A", "D"});
  EXPECT_EQ(CopyInto(draft, rules_, Find(document_, "inner"), 1), "");
  EXPECT_EQ(Shape(draft), "Sequence(A B Fallback(C A D D))");
  EXPECT_THAT(Selected(draft), ElementsAre("A", "D"));
}

TEST_F(DropEditsTest, ALeafTakesNoCopies) {
  Draft draft = DraftOf(document_, {"D"});
  EXPECT_EQ(CopyInto(draft, rules_, Find(document_, "A"), 0), "A takes no children");
}

TEST_F(DropEditsTest, ANodeGoesAroundItsSiblingOnBothSides) {
  Draft draft = DraftOf(document_, {"inner"});
  EXPECT_EQ(PutAround(draft, rules_, Find(document_, "A")), "");
  EXPECT_EQ(Shape(draft), "Sequence(Fallback(C D A) B)");
  EXPECT_THAT(Selected(draft), ElementsAre("inner"));

  const Document turned = Parsed(
      "<root BTCPP_format='4'><BehaviorTree ID='T'><S><F/><A/><B/></S></BehaviorTree></root>");
  Draft second = DraftOf(turned, {"F"});
  EXPECT_EQ(PutAround(second, rules_, Find(turned, "B")), "");
  EXPECT_EQ(Shape(second), "S(A F(B))");
}

TEST_F(DropEditsTest, ANodeGoesAroundTheRootOfAnotherTree) {
  const Document two = Parsed(
      "<root BTCPP_format='4'><BehaviorTree ID='T'><R/></BehaviorTree>"
      "<BehaviorTree ID='U'><S><F/><G/></S></BehaviorTree></root>");
  Draft draft = DraftOf(two, {"F"});
  EXPECT_EQ(PutAround(draft, rules_, Find(two, "R")), "");
  EXPECT_EQ(Shape(draft), "F(R)");
}

TEST_F(DropEditsTest, OnlyOneNodeWithRoomGoesAroundAnother) {
  Draft leaf = DraftOf(document_, {"A"});
  EXPECT_EQ(PutAround(leaf, rules_, Find(document_, "D")), "A takes no children");
  Draft two = DraftOf(document_, {"A", "inner"});
  EXPECT_EQ(PutAround(two, rules_, Find(document_, "B")), "only one node can go around another");
  Draft own = DraftOf(document_, {"inner"});
  EXPECT_NE(PutAround(own, rules_, Find(document_, "C")), "");
  EXPECT_FALSE(own.has_changed());
}

TEST_F(DropEditsTest, NodesTakeThePlaceOfAnother) {
  Draft draft = DraftOf(document_, {"A"});
  EXPECT_EQ(TakePlaceOf(draft, rules_, Find(document_, "C")), "");
  EXPECT_EQ(Shape(draft), "Sequence(B Fallback(A D))");
  EXPECT_THAT(Selected(draft), ElementsAre("A"));
}

TEST_F(DropEditsTest, AChildTakesThePlaceOfItsParent) {
  Draft draft = DraftOf(document_, {"D"});
  EXPECT_EQ(TakePlaceOf(draft, rules_, Find(document_, "inner")), "");
  EXPECT_EQ(Shape(draft), "Sequence(A B D)");
}

TEST_F(DropEditsTest, ASiblingBeforeTakesThePlaceBehindIt) {
  Draft draft = DraftOf(document_, {"A"});
  EXPECT_EQ(TakePlaceOf(draft, rules_, Find(document_, "inner")), "");
  EXPECT_EQ(Shape(draft), "Sequence(B A)");
}

TEST_F(DropEditsTest, AParentCannotTakeThePlaceOfItsChild) {
  Draft draft = DraftOf(document_, {"inner"});
  EXPECT_NE(TakePlaceOf(draft, rules_, Find(document_, "C")), "");
  EXPECT_FALSE(draft.has_changed());
}

}  // namespace
}  // namespace coppice::editor
