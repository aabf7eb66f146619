#include "editor/document/search.h"

#include <gmock/gmock.h>

#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SearchTest : public testing::Test {
 protected:
  std::vector<Match> Find(const std::string& typed) {
    query_ = ParseQuery(typed);
    return query_ ? Search(files_, models_, *query_) : std::vector<Match>();
  }
  std::vector<std::string> Texts(const std::string& typed) {
    std::vector<std::string> texts;
    for (const Match& match : Find(typed)) {
      texts.push_back(std::string(ToString(match.role)) + " " + match.before);
    }
    return texts;
  }
  std::string Replaced(const std::string& typed, const std::string& with) {
    const std::vector<Match> matches = Find(typed);
    return Apply(Replace(files_, matches, *query_, with)[0], files_[0].text());
  }

  const ProjectFiles files_ = {
      Parsed(R"(<root><BehaviorTree ID="Main"><Seq name="go on">)"
             R"(<Go goal="{goal}" say="a &lt; go"/><Action ID="Gone" _post="goal := 1"/>)"
             R"(</Seq></BehaviorTree><TreeNodesModel><Action ID="Go"/></TreeNodesModel></root>)")};
  const NodeModels models_;
  Expected<Query> query_ = Problem{};
};

TEST_F(SearchTest, FindsTypesNamesPortsAndValues) {
  EXPECT_THAT(Texts("go"), ElementsAre("name go on", "type Go", "port goal", "value {goal}",
                                       "value a < go", "type Gone", "value goal := 1"));
}

TEST_F(SearchTest, IsNarrowedByARole) {
  EXPECT_THAT(Texts("type:go"), ElementsAre("type Go", "type Gone"));
  EXPECT_THAT(Texts("key:goal"), ElementsAre("key {goal}", "key goal := 1"));
  EXPECT_THAT(Texts("name:goal"), IsEmpty());
}

TEST_F(SearchTest, CapitalsCountIfThereAreAny) {
  EXPECT_THAT(Texts("type:Go"), ElementsAre("type Go", "type Gone"));
  EXPECT_THAT(Texts("Goal"), IsEmpty());
}

TEST_F(SearchTest, TakesPatternsBetweenSlashes) {
  EXPECT_THAT(Texts("type:/^go$/"), ElementsAre("type Go"));
  EXPECT_NE(ParseQuery("/(/").problem(), "");
  EXPECT_NE(ParseQuery("").problem(), "");
}

TEST_F(SearchTest, SpecialCharactersStandForThemselves) {
  EXPECT_THAT(Texts("{goal}"), ElementsAre("value {goal}"));
  EXPECT_THAT(Texts("a < go"), ElementsAre("value a < go"));
}

TEST_F(SearchTest, ReplacesInTheTextOfTheFile) {
  EXPECT_THAT(Replaced("type:Go", "Run"), HasSubstr(R"(<Run goal="{goal}")"));
  EXPECT_THAT(Replaced("type:Gone", "<"), HasSubstr(R"(<Action ID="&lt;")"));
  EXPECT_THAT(Replaced("value:a <", "b &"), HasSubstr(R"(say="b &amp; go")"));
  EXPECT_THAT(Replaced("port:goal", "to"), HasSubstr(R"(<Go to="{goal}")"));
  EXPECT_THAT(Replaced("value:/(go)al/", "$1ld"), HasSubstr(R"(goal="{gold}")"));
  EXPECT_THAT(Replaced("value:go", "$1"), HasSubstr(R"(goal="{$1al}")"));
}

}  // namespace
}  // namespace coppice::editor
