#include "editor/diff/forest_diff.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/editor/read_forest.h"

namespace coppice::editor {
namespace {

struct Version {
  explicit Version(const std::string& trees) {
    forest = ReadForest("<root BTCPP_format=\"4\">\n" + trees + "</root>", "file.xml");
  }
  Forest forest;
  NodeModels models;
};

std::string Compare(const Version& a, const Version& b) {
  std::string text;
  for (const TreeComparison& tree : CompareForests({a.forest, a.models}, {b.forest, b.models})) {
    text += tree.id + ":" + CountDiffs(tree.diffs) + ";";
  }
  return text;
}

TEST(ForestDiff, ComparesTreesOfTheSameName) {
  const Version a(
      "<BehaviorTree ID='X'><A/></BehaviorTree><BehaviorTree ID='Y'><B/></BehaviorTree>");
  const Version b(
      "<BehaviorTree ID='Y'><B/></BehaviorTree><BehaviorTree ID='X'><A p='1'/></BehaviorTree>");
  EXPECT_EQ(Compare(a, b), "Y:;X:1 changed;");
}

TEST(ForestDiff, KnowsTreesThatCameAndWent) {
  const Version a("<BehaviorTree ID='X'><A/></BehaviorTree>");
  const Version b("<BehaviorTree ID='Z'><A><B/></A></BehaviorTree>");
  EXPECT_EQ(Compare(a, b), "Z:2 added;X:1 removed;");
}

TEST(ForestDiff, CountsAChangeOfADefinitionOnceHoweverOftenItIsUsed) {
  const std::string main =
      "<BehaviorTree ID='M'><S><SubTree ID='D'/><SubTree ID='D'/></S></BehaviorTree>";
  const Version a(main + "<BehaviorTree ID='D'><A/></BehaviorTree>");
  const Version b(main + "<BehaviorTree ID='D'><B/></BehaviorTree>");
  EXPECT_EQ(Compare(a, b).substr(0, 5), "M:;D:");
}

TEST(ForestDiff, SaysWhereANodeStandsInTheVersionThatHasIt) {
  const Version a("<BehaviorTree ID='M'><S>\n\n<A/></S></BehaviorTree>");
  const Version b("<BehaviorTree ID='M'>\n<S>\n\n\n<B/></S></BehaviorTree>");
  const auto trees = CompareForests({a.forest, a.models}, {b.forest, b.models});
  std::vector<std::string> places;
  for (const NodeDiff& diff : trees[0].diffs) {
    places.push_back(PlaceOf(diff, trees[0], a.forest, b.forest));
  }
  const auto has = [&](const char* place) {
    return std::find(places.begin(), places.end(), place) != places.end();
  };
  EXPECT_TRUE(has("file.xml:6")) << ::testing::PrintToString(places);
}

}  // namespace
}  // namespace coppice::editor
