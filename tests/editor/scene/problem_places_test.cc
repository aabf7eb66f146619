#include "editor/scene/problem_places.h"

#include <gtest/gtest.h>

#include "tests/editor/read_forest.h"

namespace coppice::editor {
namespace {

TEST(ProblemPlaces, GivesEachNodeItsWorstProblem) {
  const Forest forest = ReadForest(
      "<root BTCPP_format='4'><BehaviorTree ID='T'>\n<A>\n<B "
      "x='1'/>\n<C/></A></BehaviorTree></root>",
      "t.xml");
  const Scene scene = BuildScene(forest, 0, NodeModels());
  const std::vector<Diagnostic> problems = {
      {Severity::kWarning, {"t.xml", 3, 4}, "in a port of B", ""},
      {Severity::kError, {"t.xml", 3, 1}, "B", ""},
      {Severity::kWarning, {"t.xml", 4, 2}, "C", ""},
      {Severity::kError, {"other.xml", 2, 1}, "of another file", ""},
      {Severity::kError, {"t.xml", 0, 0}, "nowhere", ""}};
  EXPECT_EQ(PlaceProblems(forest, scene, problems), (std::vector<std::uint8_t>{0, 2, 1}));
  EXPECT_TRUE(PlaceProblems(forest, scene, {}).empty());
}

}  // namespace
}  // namespace coppice::editor
