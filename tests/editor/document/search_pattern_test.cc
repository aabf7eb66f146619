#include "editor/document/search_pattern.h"

#include <gmock/gmock.h>

namespace coppice::editor {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> Texts(const SearchPattern& pattern, std::string_view text) {
  std::vector<std::string> texts;
  for (const SearchPattern::Found& found : pattern.In(text)) {
    texts.emplace_back(text.substr(found.begin, found.end - found.begin));
  }
  return texts;
}

TEST(SearchPatternTest, PlainCharactersStandForThemselves) {
  EXPECT_THAT(Texts(SearchPattern::Literal("a.b", false), "aXb a.b"), ElementsAre("a.b"));
}

TEST(SearchPatternTest, CapitalsAreTheSameIfAskedFor) {
  EXPECT_THAT(Texts(SearchPattern::Literal("Go", true), "go GO no"), ElementsAre("go", "GO"));
  EXPECT_THAT(Texts(SearchPattern::Literal("Go", false), "go GO Go"), ElementsAre("Go"));
  EXPECT_THAT(Texts(*SearchPattern::Regular("G[o]", true), "go GO no"), ElementsAre("go", "GO"));
}

TEST(SearchPatternTest, MatchesDoNotOverlap) {
  EXPECT_THAT(Texts(SearchPattern::Literal("aa", false), "aaaaa"), ElementsAre("aa", "aa"));
  EXPECT_THAT(Texts(*SearchPattern::Regular("aa", false), "aaaaa"), ElementsAre("aa", "aa"));
}

TEST(SearchPatternTest, AMatchIsNeverEmpty) {
  EXPECT_THAT(Texts(*SearchPattern::Regular("a*", false), "baab"), ElementsAre("aa"));
}

TEST(SearchPatternTest, AReplacementNamesGroupsOnlyInAnExpression) {
  EXPECT_EQ(SearchPattern::Regular("go(al)", false)->In("goal", "<$1>").at(0).with, "<al>");
  EXPECT_EQ(SearchPattern::Literal("goal", false).In("goal", "<$1>").at(0).with, "<$1>");
}

TEST(SearchPatternTest, RefusesWhatIsMalformedOrEndless) {
  EXPECT_FALSE(SearchPattern::Regular("(", false));
  EXPECT_FALSE(SearchPattern::Regular(std::string(100'000, '('), false));
  EXPECT_FALSE(SearchPattern::Regular("((a{1000}){1000}){1000}", false));
}

TEST(SearchPatternTest, ALongTextDoesNotOverflowTheStack) {
  const std::string text(1'000'000, 'a');
  const auto found = SearchPattern::Regular("(a|b)*", false)->In(text);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].end, SearchPattern::kLongestText);
  EXPECT_EQ(SearchPattern::Literal(text, false).In(text).size(), 1u);
}

// Would try 2^40 ways one after the other.
TEST(SearchPatternTest, AnAmbiguousPatternEnds) {
  EXPECT_THAT(Texts(*SearchPattern::Regular("^(a+)+$", false), std::string(40, 'a') + "b"),
              IsEmpty());
}

TEST(SearchPatternTest, PlainCharactersAreFoundAtTheEndOfALongText) {
  EXPECT_EQ(SearchPattern::Literal("end", false).In(std::string(1'000'000, 'a') + "end").size(),
            1u);
}

}  // namespace
}  // namespace coppice::editor
