#include "robot_app/assistance/page/running_path.h"

#include <gmock/gmock.h>

#include <chrono>
#include <optional>
#include <thread>

#include "tests/bt_core/live/robot.h"

namespace coppice::robot::assistance {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr Status kRuns = Status::kRunning;
constexpr Status kRests = Status::kIdle;

// Patrol > { Charge > Dock, Round > Round > NavigateTo }.
TreeDescription Sample() {
  TreeDescription tree;
  const auto add = [&](const std::string& path, std::uint32_t parent) {
    DescribedNode node;
    node.path = path;
    node.parent = NodeIndex(parent);
    tree.nodes.push_back(node);
  };
  add("Patrol", 0);
  add("Patrol/Charge", 0);
  add("Patrol/Charge/Dock", 1);
  add("Patrol/Round", 0);
  add("Patrol/Round/Round", 3);
  add("Patrol/Round/NavigateTo::39", 4);
  return tree;
}

TEST(RunningPath, LeadsFromTheRootToTheLeafThatRuns) {
  EXPECT_THAT(RunningPath(Sample(), {kRuns, kRests, kRests, kRuns, kRuns, kRuns}),
              ElementsAre("Patrol", "Round", "NavigateTo"));
}

TEST(RunningPath, TakesTheFirstOfSeveralThatRun) {
  EXPECT_THAT(RunningPath(Sample(), {kRuns, kRuns, kRuns, kRuns, kRuns, kRuns}),
              ElementsAre("Patrol", "Charge", "Dock"));
}

TEST(RunningPath, IsEmptyIfNothingRuns) {
  EXPECT_THAT(RunningPath(Sample(), {Status::kSuccess, kRests, kRests, kRests, kRests, kRests}),
              IsEmpty());
  EXPECT_THAT(RunningPath({}, {}), IsEmpty());
}

TEST(RunningPathFollower, SeesATreeThroughItsLiveSocketAndItsEnd) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  const auto await = [&](const auto& condition) {
    while (!condition()) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      std::this_thread::yield();
    }
    return true;
  };
  std::optional<coppice::Robot> robot(std::in_place);
  RunningPathFollower follower(robot->endpoint());
  EXPECT_TRUE(await([&] {
    robot->Tick(1);
    return follower.Now().is_live;
  }));
  robot.reset();
  EXPECT_TRUE(await([&] { return !follower.Now().is_live; }));
}

}  // namespace
}  // namespace coppice::robot::assistance
