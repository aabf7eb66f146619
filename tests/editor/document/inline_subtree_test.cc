#include <gmock/gmock.h>

#include "editor/document/subtree_edits.h"
#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;

// A tree that uses another; `attributes` are those of the SubTree.
std::string Trees(const std::string& attributes, const std::string& body) {
  return R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <Sequence>
      <A x="{count}"/>
      <SubTree ID="Walk")" +
         attributes + R"(/>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Walk">
    )" + body +
         R"(
  </BehaviorTree>
</root>
)";
}

class InlineSubTreeTest : public testing::Test {
 protected:
  // The refusal, or the text of Main.
  std::string Inlined(const std::string& attributes, const std::string& body) {
    const Document document = Parsed(Trees(attributes, body));
    Draft draft(document, {Find(document, "SubTree")});
    const Outcome inlined = InlineSubTree(draft, rules_, document, Tree(document));
    if (!inlined) return inlined.problem();
    const std::string& text = draft.document().text();
    const std::size_t begin = text.find("      <A");
    return text.substr(begin, text.find("\n    </Sequence>", begin) + 1 - begin);
  }

  static ElementIndex Tree(const Document& document) {
    ElementIndex tree{0};
    while (document.AttributeValue(document.element(tree), "ID") != "Walk" ||
           document.element(tree).tag != "BehaviorTree") {
      ++tree;
    }
    return tree;
  }

  NodeModels models_;
  const NodeRules rules_{models_};
};

TEST_F(InlineSubTreeTest, KeysGetTheNamesThatTheyHaveOutside) {
  EXPECT_EQ(Inlined(R"( goal="{place}")",
                    "<Sequence>\n      <Go to=\"{goal}\" _skipIf=\"goal == 1\"/>\n    </Sequence>"),
            "      <A x=\"{count}\"/>\n      <Sequence>\n"
            "        <Go to=\"{place}\" _skipIf=\"place == 1\"/>\n      </Sequence>\n");
}

TEST_F(InlineSubTreeTest, AKeyOfItsOwnStaysApartFromOneOfTheSameName) {
  EXPECT_THAT(Inlined("", R"(<B x="{count}" y="{count}" z="{other}"/>)"),
              HasSubstr(R"(<B x="{count_inner}" y="{count_inner}" z="{other}"/>)"));
  for (const char* yes : {"true", "True", "1"}) {
    EXPECT_THAT(Inlined(" _autoremap='" + std::string(yes) + "'", "<B x='{count}'/>"),
                HasSubstr("<B x='{count}'/>"));
  }
}

TEST_F(InlineSubTreeTest, ALiteralTakesThePlaceOfItsKey) {
  EXPECT_THAT(Inlined(R"( goal="a &lt; &quot;b&quot;")", "<B x='{goal}'/>"),
              HasSubstr(R"(<B x='a &lt; "b"'/>)"));
  EXPECT_THAT(Inlined(R"( goal="7")", R"(<B _onStart="x := goal"/>)"), HasSubstr("literal"));
}

TEST_F(InlineSubTreeTest, NameAndGuardsOfTheSubTreeGoOn) {
  EXPECT_THAT(Inlined(R"( name="walk" _skipIf="ill")", "<B/>"),
              HasSubstr(R"(<B name="walk" _skipIf="ill"/>)"));
  EXPECT_THAT(Inlined(R"( _skipIf="ill")", R"(<B _failureIf="late"/>)"), HasSubstr("both"));
}

TEST_F(InlineSubTreeTest, WhatWouldChangeItsMeaningIsRefused) {
  EXPECT_THAT(
      Inlined(R"( goal="{place}")", R"(<C x="{goal}"><SubTree ID="Deep" _autoremap="true"/></C>)"),
      HasSubstr("_autoremap"));
  EXPECT_EQ(Inlined("", ""), "that tree is empty");
}

TEST_F(InlineSubTreeTest, UndoesAnExtraction) {
  const std::string before = Trees(R"( goal="{goal}")", R"(<Go to="{goal}"/>)");
  const Document document = Parsed(before);
  Draft draft(document, {Find(document, "SubTree")});
  ASSERT_EQ(InlineSubTree(draft, rules_, document, Tree(document)).problem(), "");
  ASSERT_EQ(ExtractSubTree(draft, rules_, "Walk2", {}).problem(), "");
  EXPECT_THAT(draft.document().text(), HasSubstr(R"(<SubTree ID="Walk2" goal="{goal}"/>)"));
}

}  // namespace
}  // namespace coppice::editor
