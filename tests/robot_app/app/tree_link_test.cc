#include "robot_app/app/tree_link.h"

#include <gtest/gtest.h>

namespace coppice::robot {
namespace {

std::unique_ptr<TreeRunner> MakeRunner(const std::string& key, Clock& clock) {
  Diagnostics diagnostics;
  auto project = Project::FromText(
      R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><ScriptCondition code=")" + key +
          " == true\"/></BehaviorTree></root>",
      "link", diagnostics);
  auto program = Compile(std::make_shared<const Project>(*std::move(project)),
                         std::make_shared<const Registry>(), diagnostics);
  EXPECT_TRUE(program) << diagnostics.ToString();
  return std::make_unique<TreeRunner>(program, clock, TreeRunnerOptions{});
}

TEST(TreeLink, WritesTheKeysOfTheOtherTree) {
  SimulatedClock clock{std::chrono::seconds(1)};
  const auto application = MakeRunner("charge_requested", clock);
  const auto monitor = MakeRunner("going_home", clock);
  TreeLink link;
  link.SetChargeRequested(true);  // nobody is there yet
  link.Suspend();
  link.Resume();
  link.Connect(*application, *monitor);
  EXPECT_EQ(application->executor().Tick(), Status::kFailure);
  EXPECT_EQ(monitor->executor().Tick(), Status::kFailure);
  link.SetChargeRequested(true);
  link.SetGoingHome(true);
  EXPECT_EQ(application->executor().Tick(), Status::kSuccess);
  EXPECT_EQ(monitor->executor().Tick(), Status::kSuccess);
}

}  // namespace
}  // namespace coppice::robot
