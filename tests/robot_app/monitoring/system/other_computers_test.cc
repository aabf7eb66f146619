#include "robot_app/monitoring/system/other_computers.h"

#include <gmock/gmock.h>

namespace coppice::robot::monitoring {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

ProcessTable Robot() {
  ProcessTable processes;
  processes.hosts = {{"/camera", "jetson"}, {"/driver", "jetson"}, {"/speech", "pi"}};
  return processes;
}

TEST(OtherComputers, OneNodeOnEachIsAskedUntilItHasAnswered) {
  OtherComputers computers("robot", "10.0.0.1");
  EXPECT_THAT(computers.NodesToAsk(Robot()), ElementsAre("/camera", "/speech"));
  EXPECT_THAT(computers.List(Robot()), IsEmpty());
  computers.OnAddress(Robot(), "/camera", "10.0.0.3");
  EXPECT_THAT(computers.NodesToAsk(Robot()), ElementsAre("/speech"));
  EXPECT_THAT(computers.List(Robot()), ElementsAre(Computer{"jetson", "10.0.0.3"}));
}

TEST(OtherComputers, OneThatWasFoundStaysWhenItIsGone) {
  OtherComputers computers("robot", "10.0.0.1");
  computers.OnAddress(Robot(), "/camera", "10.0.0.3");
  EXPECT_THAT(computers.List({}), ElementsAre(Computer{"jetson", "10.0.0.3"}));
}

TEST(OtherComputers, FromAnotherComputerTheSupervisorsOwnIsCalledMain) {
  OtherComputers computers("jetson", "10.0.0.1");
  EXPECT_THAT(computers.NodesToAsk(Robot()), ElementsAre("/speech"));
  EXPECT_THAT(computers.List(Robot()), ElementsAre(Computer{"main", "10.0.0.1"}));
}

TEST(OtherComputers, NodesOfThisComputerTellNothing) {
  OtherComputers computers("robot", "10.0.0.1");
  computers.OnAddress(Robot(), "/navigation", "127.0.0.1");
  EXPECT_THAT(computers.List(Robot()), IsEmpty());
}

}  // namespace
}  // namespace coppice::robot::monitoring
