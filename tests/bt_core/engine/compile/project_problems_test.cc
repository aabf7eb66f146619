#include "bt_core/engine/compile/project_problems.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

struct ProjectProblemsTest : testing::Test {
  const TreeDefinition* Find(const std::string& attributes, const std::string& id) {
    project = Project::FromText(R"(<root BTCPP_format="4")" + attributes +
                                    R"(><BehaviorTree ID="A"><AlwaysSuccess/></BehaviorTree>)"
                                    "<BehaviorTree ID=\"B\"><AlwaysSuccess/></BehaviorTree></root>",
                                "t.xml", diagnostics);
    return FindMainTree(*project, id, problems);
  }

  Diagnostics diagnostics;
  Problems problems{diagnostics};
  std::optional<Project> project;
};

TEST_F(ProjectProblemsTest, FindsTheMainTree) {
  EXPECT_NE(Find("", "B"), nullptr);
  EXPECT_EQ(diagnostics.ToString(), "");
}

TEST_F(ProjectProblemsTest, AsksForAMainTreeIfThereAreSeveral) {
  EXPECT_EQ(Find("", ""), nullptr);
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:1:1: error: which tree is the main one? "
            "(give main_tree_to_execute; there are: A, B)\n");
}

TEST_F(ProjectProblemsTest, ATreeWithoutNodesIsNotMissing) {
  project = Project::FromText(R"(<root BTCPP_format="4"><BehaviorTree ID="C"/></root>)", "t.xml",
                              diagnostics);
  const std::string said = diagnostics.ToString();
  EXPECT_EQ(FindMainTree(*project, "C", problems), nullptr);
  EXPECT_EQ(diagnostics.ToString(), said) << "its place has said it";
}

TEST_F(ProjectProblemsTest, PointsAtTheAttributeThatNamesAMissingTree) {
  EXPECT_EQ(Find(R"( main_tree_to_execute="b")", "b"), nullptr);
  EXPECT_EQ(diagnostics.ToString(), "t.xml:1:46: error: no tree \"b\" (did you mean \"B\"?)\n");
}

TEST_F(ProjectProblemsTest, ATreeMayNotHaveTheNameOfANodeType) {
  project = Project::FromText(
      "<root BTCPP_format=\"4\">\n<BehaviorTree ID=\"Sequence\"><A/>"
      "</BehaviorTree></root>",
      "t.xml", diagnostics);
  CheckTreeNames(*project, Registry(), problems);
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:2:1: error: tree \"Sequence\" has the name of a node type\n");
}

TEST_F(ProjectProblemsTest, ATreeMayNotHaveTheNameOfALeafThatAModelDescribes) {
  project = Project::FromText(
      "<root BTCPP_format=\"4\">\n<BehaviorTree ID=\"Dock\"><A/></BehaviorTree>\n"
      "<TreeNodesModel><Action ID=\"Dock\"/></TreeNodesModel></root>",
      "t.xml", diagnostics);
  CheckTreeNames(*project, Registry(), problems);
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:2:1: error: tree \"Dock\" has the name of a node type (its model is at "
            "t.xml:3)\n");
}

}  // namespace
}  // namespace coppice
