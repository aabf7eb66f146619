#include "editor/document/drop_edits.h"

#include <gmock/gmock.h>

#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class DropEditsTest : public testing::Test {
 protected:
  DropEditsTest() { models_.AddFrom(document_); }
  DropSpot At(DropSpot::Kind kind, const std::string& name) {
    return {kind, Find(document_, name), UINT32_MAX};
  }
  const Document document_ = Parsed(kRound);
  NodeModels models_;
  const NodeRules rules_{models_};
};

TEST_F(DropEditsTest, ANewNodeGoesBetweenOthersOrInTheirPlaceOrAround) {
  Draft into(document_);
  EXPECT_EQ(DropNew(into, rules_, {DropSpot::Kind::kInto, Find(document_, "top"), 1}, {"<New/>"})
                .problem(),
            "");
  EXPECT_THAT(into.document().text(), HasSubstr("<A/>\n      <New/>\n"));
  Draft place(document_);
  EXPECT_EQ(DropNew(place, rules_, At(DropSpot::Kind::kReplace, "C"), {"<New/>"}).problem(), "");
  EXPECT_THAT(place.document().text(), HasSubstr("<New/>\n        <D/>"));
  Draft around(document_);
  EXPECT_EQ(DropNew(around, rules_, At(DropSpot::Kind::kAround, "C"), {"<Inverter/>"}).problem(),
            "");
  EXPECT_THAT(around.document().text(),
              HasSubstr("        <Inverter>\n          <C msec='5'/>\n        </Inverter>\n"));
  EXPECT_THAT(Selected(around), ElementsAre("Inverter"));
}

TEST_F(DropEditsTest, ANodeWithChildrenKeepsThemWhenAnotherTakesItsPlace) {
  Draft draft(document_);
  EXPECT_EQ(
      DropNew(draft, rules_, At(DropSpot::Kind::kReplace, "inner"), {"<Sequence/>"}).problem(), "");
  EXPECT_THAT(draft.document().text(), HasSubstr("<Sequence name=\"inner\">\n        <C"));
}

TEST_F(DropEditsTest, ANodeIsMovedToWhereItIsDropped) {
  Draft into = DraftOf(document_, {"A"});
  EXPECT_EQ(DropMoved(into, rules_, {DropSpot::Kind::kInto, Find(document_, "inner"), 1}).problem(),
            "");
  EXPECT_THAT(into.document().text(), HasSubstr("<C msec='5'/>\n        <A/>\n"));
  Draft place = DraftOf(document_, {"A"});
  EXPECT_EQ(DropMoved(place, rules_, At(DropSpot::Kind::kReplace, "D")).problem(), "");
  EXPECT_THAT(place.document().text(), HasSubstr("<C msec='5'/>\n        <A/>\n      </Fall"));
  EXPECT_THAT(Selected(place), ElementsAre("A"));
  Draft around = DraftOf(document_, {"inner"});
  EXPECT_EQ(DropMoved(around, rules_, At(DropSpot::Kind::kAround, "A")).problem(), "");
  EXPECT_THAT(around.document().text(), HasSubstr("<D/>\n        <A/>\n      </Fallback>"));
}

TEST_F(DropEditsTest, WhatMakesNoSenseIsRefused) {
  Draft draft = DraftOf(document_, {"inner"});
  EXPECT_FALSE(DropMoved(draft, rules_, At(DropSpot::Kind::kReplace, "C")));
  EXPECT_FALSE(DropMoved(draft, rules_, At(DropSpot::Kind::kInto, "C")));
  EXPECT_FALSE(DropMoved(draft, rules_, At(DropSpot::Kind::kAround, "top")));
  EXPECT_FALSE(DropNew(draft, rules_, At(DropSpot::Kind::kAround, "C"), {"<A/>"}));
  EXPECT_FALSE(draft.has_changed());
}

}  // namespace
}  // namespace coppice::editor
