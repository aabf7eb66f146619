// CompileSuite: the tree that a file of scenarios names, with stand-ins for the robot's nodes.
#include <gtest/gtest.h>

#include "bt_core/model/project.h"
#include "bt_core/testing/scenario.h"

namespace coppice {
namespace {

class CompileSuiteTest : public testing::Test {
 protected:
  std::shared_ptr<const Program> Compiled(const ScenarioSuite& suite) {
    std::optional<Project> project = Project::FromText(
        R"(<root BTCPP_format="4" main_tree_to_execute="Main">
           <BehaviorTree ID="Main"><Drive goal="{goal}"/></BehaviorTree>
           <BehaviorTree ID="Other"><Wait/></BehaviorTree></root>)",
        "test.xml", diagnostics_);
    return CompileSuite(suite, *std::move(project), nullptr, diagnostics_);
  }
  Diagnostics diagnostics_;
};

TEST_F(CompileSuiteTest, NodesThatOnlyTheRobotKnowsHaveStandIns) {
  const auto program = Compiled({});
  ASSERT_TRUE(program) << diagnostics_.ToString();
  EXPECT_EQ(program->Id(kRootNode), "Drive");
  EXPECT_NE(program->layout.Find(kMainScope, "goal"), kNoSlot);
}

TEST_F(CompileSuiteTest, TakesTheTreeThatTheSuiteNames) {
  ScenarioSuite suite;
  suite.tree_id = "Other";
  const auto program = Compiled(suite);
  ASSERT_TRUE(program) << diagnostics_.ToString();
  EXPECT_EQ(program->Id(kRootNode), "Wait");
  suite.tree_id = "None";
  EXPECT_FALSE(Compiled(suite));
  EXPECT_TRUE(diagnostics_.has_errors());
}

TEST_F(CompileSuiteTest, ModelsThatCannotBeReadAreAnError) {
  ScenarioSuite suite;
  suite.models_file = "/nonexistent/models.xml";
  EXPECT_FALSE(Compiled(suite));
  EXPECT_NE(diagnostics_.ToString().find("/nonexistent/models.xml"), std::string::npos);
}

}  // namespace
}  // namespace coppice
