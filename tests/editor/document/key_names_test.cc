#include "editor/document/key_names.h"

#include <gmock/gmock.h>

#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> Keys(const std::string& nodes) {
  const Document document = Parsed(R"(<root BTCPP_format="4"><BehaviorTree ID="Main">)" + nodes +
                                   "</BehaviorTree></root>");
  std::vector<std::string> keys;
  for (const KeyName& name : KeyNamesIn(document, NodeModels(), ElementIndex{1})) {
    const std::string place = document.text().substr(name.begin, name.end - name.begin);
    EXPECT_THAT(place, AnyOf(HasSubstr(name.key), HasSubstr("=")));
    keys.push_back((name.is_global ? "@" : "") + name.key + (name.reads ? " r" : "") +
                   (name.writes ? " w" : ""));
  }
  return keys;
}

TEST(KeyNames, AreFoundInPortsAndScripts) {
  EXPECT_THAT(Keys(R"(<Go goal="{goal}" speed="{@speed}" text="in {braces} somewhere"/>)"),
              ElementsAre("goal r", "@speed r"));
  EXPECT_THAT(Keys(R"(<Script code="a := b + 1; c += 2; d = true"/>)"),
              ElementsAre("a w", "b r", "c r w", "d w"));
  EXPECT_THAT(Keys(R"(<Go _skipIf="battery &lt; 20"/>)"), ElementsAre("battery r"));
}

// Name by name from the beginning it would take hours.
TEST(KeyNames, OfAHugeScriptAreFoundInOnePass) {
  std::string code = "a &lt; 1";
  for (int i = 0; i < 100'000; ++i) code += " || b == 1";
  const Document document =
      Parsed(R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Go _skipIf=")" + code +
             R"("/></BehaviorTree></root>)");
  const auto names = KeyNamesIn(document, NodeModels(), ElementIndex{1});
  ASSERT_EQ(names.size(), 100'001U);
  EXPECT_EQ(names.back().begin, document.text().rfind("b =="));
}

TEST(KeyNames, AreWhatTheEngineTakesForKeys) {
  EXPECT_THAT(Keys("<Go goal=' {goal} ' speed='{ fast }' where='=' text='{a}_{b}'/>"),
              ElementsAre("goal r", "fast r", "where r"));
}

TEST(KeyNames, KnowTheDirectionOfAPort) {
  EXPECT_THAT(Keys(R"(<SetBlackboard value="{from}" output_key="to"/>)"),
              ElementsAre("from r", "to w"));
}

TEST(KeyNames, OfASubTreeAreHandedOn) {
  EXPECT_THAT(Keys(R"(<SubTree ID="Walk" goal="{place}" speed="{=}" loud="true"/>)"),
              ElementsAre("place", "speed"));
}

TEST(KeyNames, WordsInCapitalsThatNobodyAssignsAreNoKeys) {
  EXPECT_THAT(Keys(R"(<Script code="color := RED"/>)"), ElementsAre("color w"));
  EXPECT_THAT(Keys(R"(<Script code="RED := 1; color := RED"/>)"),
              ElementsAre("RED w", "color w", "RED r"));
}

TEST(KeyNames, AnotherKeyTakesTheirPlace) {
  const Document document =
      Parsed(R"(<root><BehaviorTree ID="M"><A x="{k}" y="{=}" _post="k &lt; k"/></BehaviorTree>)"
             "</root>");
  Edit edit;
  for (const KeyName& name : KeyNamesIn(document, NodeModels(), kRootElement)) {
    edit = Merge(std::move(edit), {WithKey(name, "new")});
  }
  EXPECT_EQ(Apply(edit, document.text()),
            R"(<root><BehaviorTree ID="M"><A x="{new}" y="{new}" _post="new &lt; new"/>)"
            "</BehaviorTree></root>");
}

TEST(KeyNames, HaveLettersAndDigits) {
  EXPECT_TRUE(IsKeyName("goal_2"));
  EXPECT_TRUE(IsKeyName("@goal"));
  for (const char* bad : {"", "a b", "2a", "a-b", "{a}", "a "}) EXPECT_FALSE(IsKeyName(bad)) << bad;
}

}  // namespace
}  // namespace coppice::editor
