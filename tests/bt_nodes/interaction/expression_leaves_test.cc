#include "bt_nodes/interaction/expression_leaves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <utility>

#include "bt_core/engine/program.h"
#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Expressions, AnUnknownOneIsRefusedWhenTheTreeIsLoaded) {
  FakeRobot robot;
  auto registry = std::make_shared<Registry>();
  RegisterNodes(*registry, robot.capabilities());
  Diagnostics diagnostics;
  auto project = Project::FromText(
      R"(<root BTCPP_format="4"><BehaviorTree ID="T"><SetExpression expression="SMILING"/></BehaviorTree></root>)",
      "tree.xml", diagnostics);
  ASSERT_TRUE(project);
  EXPECT_EQ(Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics),
            nullptr);
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("LAUGHING"));
}

TEST(SetExpression, LooksLikeThatAtOnce) {
  FakeRobot robot;
  LeafHarness leaf = LeafHarness::For<SetExpression>(std::ref<Face>(robot));
  leaf.Set("expression", Expression::SLEEP);
  EXPECT_EQ(leaf.Tick(), Status::kSuccess);
  EXPECT_THAT(robot.calls, ElementsAre("SetExpression SLEEP"));
}

TEST(Express, HoldsItUntilTheChildHasEnded) {
  FakeRobot robot;
  LeafHarness leaf = LeafHarness::WithChildren<Express>(1, std::ref<Face>(robot));
  leaf.Set("expression", Expression::GREETING);
  leaf.SetChild(0, {Status::kRunning, Status::kRunning, Status::kFailure});
  leaf.Tick();
  leaf.Tick();
  EXPECT_THAT(robot.calls, ElementsAre("Hold GREETING"));
  EXPECT_EQ(leaf.Tick(), Status::kFailure);
  EXPECT_THAT(robot.calls, ElementsAre("Hold GREETING", "Release GREETING"));
}

TEST(Express, ReleasesItWhenHalted) {
  FakeRobot robot;
  LeafHarness leaf = LeafHarness::WithChildren<Express>(1, std::ref<Face>(robot));
  leaf.Set("expression", Expression::GUIDING);
  leaf.SetChild(0, {Status::kRunning});
  leaf.Tick();
  leaf.Halt();
  EXPECT_THAT(robot.calls, ElementsAre("Hold GUIDING", "Release GUIDING"));
}

}  // namespace
}  // namespace coppice::leaves
