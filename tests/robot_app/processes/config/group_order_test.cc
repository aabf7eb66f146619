#include "robot_app/processes/config/group_order.h"

#include <gmock/gmock.h>

#include "tests/robot_app/processes/simulated_machine.h"

namespace coppice::robot::processes {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

// In the file: nav (2 processes) depends on the group loc; a process of loc depends on base.
RobotConfig Config() {
  RobotConfig config;
  config.processes = {MakeProcess("planner"), MakeProcess("follower"), MakeProcess("loc", {3}),
                      MakeProcess("base"), MakeProcess("speech")};
  config.groups.resize(4);
  config.groups[0].processes = {0, 1};
  config.groups[0].depends = {1};
  config.groups[1].processes = {2};
  config.groups[2].processes = {3};
  config.groups[3].processes = {4};
  for (std::size_t group = 0; group < 4; ++group) {
    for (const std::size_t member : config.groups[group].processes) {
      config.processes[member].group = group;
    }
  }
  return config;
}

TEST(GroupOrderTest, AProcessNeedsThoseThatItNamesAndThoseOfTheGroupsThatItsGroupNames) {
  const RobotConfig config = Config();
  const GroupOrder order(config);
  EXPECT_THAT(order.needs(0), ElementsAre(2u));
  EXPECT_THAT(order.needs(1), ElementsAre(2u));
  EXPECT_THAT(order.needs(2), ElementsAre(3u));
  EXPECT_THAT(order.needs(4), ElementsAre());
}

TEST(GroupOrderTest, DependenciesComeFirstInUpstreamAndClosure) {
  const RobotConfig config = Config();
  const GroupOrder order(config);
  EXPECT_THAT(order.upstream(0), ElementsAre(2u, 1u, 0u));
  EXPECT_THAT(order.closure(2), ElementsAre(2u, 1u, 0u));
  EXPECT_THAT(order.closure(0), ElementsAre(0u));
  EXPECT_THAT(order.closure(3), ElementsAre(3u));
  EXPECT_THAT(order.Members(order.closure(1)), ElementsAre(2u, 0u, 1u));
  EXPECT_THAT(order.circular(), ElementsAre());
}

TEST(GroupOrderTest, TheStrategySaysWhatIsRestartedTogether) {
  RobotConfig config = Config();
  EXPECT_THAT(GroupOrder(config).RestartedWith(1), ElementsAre(1u));
  config.groups[0].strategy = Strategy::kOneForAll;
  EXPECT_THAT(GroupOrder(config).RestartedWith(1), ElementsAre(0u, 1u));
  config.groups[0].strategy = Strategy::kRestForOne;
  EXPECT_THAT(GroupOrder(config).RestartedWith(1), ElementsAre(1u));
  EXPECT_THAT(GroupOrder(config).RestartedWith(0), ElementsAre(0u, 1u));
}

TEST(GroupOrderTest, FindsGroupsThatWaitForThemselves) {
  RobotConfig config = Config();
  config.groups[2].depends = {0};
  EXPECT_THAT(GroupOrder(config).circular(), UnorderedElementsAre(0u, 1u, 2u));
}

}  // namespace
}  // namespace coppice::robot::processes
