#include <gmock/gmock.h>

#include "bt_core/model/upgrade.h"
#include "editor/document/subtree_edits.h"
#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr char kTree[] = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <Sequence name="top">
      <FindPlace name="find" place="{place}"/>
      <Sequence name="go">
        <PlanPath name="plan" to="{place}" path="{path}"/>
        <Follow path="{path}" speed="{speed}"/>
        <Script code="done := true"/>
      </Sequence>
      <Beep/>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Last">
    <Beep/>
  </BehaviorTree>
  <TreeNodesModel>
    <Action ID="FindPlace"><output_port name="place"/></Action>
    <Action ID="PlanPath"><input_port name="to"/><output_port name="path"/></Action>
    <Action ID="Follow"><input_port name="path"/><input_port name="speed"/></Action>
  </TreeNodesModel>
</root>
)";

class ExtractSubTreeTest : public testing::Test {
 protected:
  ExtractSubTreeTest() { models_.AddFrom(document_); }

  const Document document_ = Parsed(kTree);
  NodeModels models_;
  const NodeRules rules_{models_};
};

TEST_F(ExtractSubTreeTest, KeysThatTheRestUsesAndThoseOnlyReadGoAcross) {
  const ElementIndex go = Find(document_, "go");
  EXPECT_THAT(KeysAcross(document_, rules_, go, {{}, false, false}), ElementsAre("place", "speed"));
  EXPECT_THAT(KeysAcross(document_, rules_, go, {{"done"}, false, false}),
              ElementsAre("place", "speed", "done"));
  EXPECT_THAT(KeysAcross(document_, rules_, go, {{}, true}),
              ElementsAre("place", "path", "speed", "done"));
  EXPECT_THAT(KeysAcross(document_, rules_, Find(document_, "find"), {}), ElementsAre("place"));
  EXPECT_THAT(KeysAcross(document_, rules_, Find(document_, "Beep"), {}), IsEmpty());
}

TEST_F(ExtractSubTreeTest, WhatIsOnlyWrittenIsForTheApplicationThatRunsTheTree) {
  EXPECT_THAT(KeysAcross(document_, rules_, Find(document_, "go"), {}),
              ElementsAre("place", "speed", "done"));
}

TEST_F(ExtractSubTreeTest, TheNewTreeStandsBehindTheOldOne) {
  Draft draft = DraftOf(document_, {"go"});
  EXPECT_EQ(ExtractSubTree(draft, rules_, "Go", {}).problem(), "");
  EXPECT_THAT(draft.document().text(), HasSubstr(R"(
      <FindPlace name="find" place="{place}"/>
      <SubTree ID="Go" place="{place}" speed="{speed}" done="{done}"/>
      <Beep/>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Go">
    <Sequence name="go">
      <PlanPath name="plan" to="{place}" path="{path}"/>
      <Follow path="{path}" speed="{speed}"/>
      <Script code="done := true"/>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Last">)"));
  EXPECT_THAT(Selected(draft), ElementsAre("Go"));
}

// In format 3 the attributes of a SubTree name keys; braces would make a file that says no format
// one of format 4.
TEST_F(ExtractSubTreeTest, AFileOfFormat3StaysOneAndCanBeTakenBack) {
  const std::string body = R"(<Sequence name="go">
        <PlanPath name="plan" to="{place}"/>
        <SubTree ID="Other" goal="place"/>
      </Sequence>)";
  for (const char* format : {"", R"( BTCPP_format="3")"}) {
    const Document document = Parsed("<root" + std::string(format) + R"(>
  <BehaviorTree ID="Main">
    <Sequence>
      <FindPlace place="{place}"/>
      )" + body + R"(
    </Sequence>
  </BehaviorTree>
</root>
)");
    Draft draft = DraftOf(document, {"go"});
    EXPECT_EQ(ExtractSubTree(draft, rules_, "Go", {}).problem(), "");
    EXPECT_THAT(draft.document().text(), HasSubstr(R"(<SubTree ID="Go" place="place"/>)"));
    EXPECT_TRUE(IsFormat3(draft.document()));
    const Document extracted = draft.document();
    EXPECT_EQ(
        InlineSubTree(draft, rules_, extracted, TreeOf(extracted, Find(extracted, "go"))).problem(),
        "");
    EXPECT_THAT(draft.document().text(), HasSubstr(body));
  }
}

TEST_F(ExtractSubTreeTest, TheRootOfATreeCanBeExtracted) {
  Draft draft = DraftOf(document_, {"top"});
  EXPECT_EQ(ExtractSubTree(draft, rules_, "A & B", {}).problem(), "");
  EXPECT_THAT(draft.document().text(),
              HasSubstr("<BehaviorTree ID=\"Main\">\n    <SubTree ID=\"A &amp; B\""));
}

TEST_F(ExtractSubTreeTest, SeveralNodesAndNoNameAreRefused) {
  Draft several = DraftOf(document_, {"find", "go"});
  EXPECT_FALSE(ExtractSubTree(several, rules_, "Go", {}));
  Draft one = DraftOf(document_, {"go"});
  EXPECT_FALSE(ExtractSubTree(one, rules_, "", {}));
  EXPECT_FALSE(one.has_changed());
}

}  // namespace
}  // namespace coppice::editor
