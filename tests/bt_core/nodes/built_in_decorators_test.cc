// The names, ports and defaults of the peer's nodes (BehaviorTree.CPP 4).
#include <gtest/gtest.h>

#include "bt_core/nodes/built_in_tables.h"
#include "tests/bt_core/nodes/ports_of.h"

namespace coppice {
namespace {

TEST(BuiltInDecorators, HaveThePortsOfThePeer) {
  const PortsOf ports(BuiltInDecorators());
  EXPECT_EQ(ports("Inverter"), "");
  EXPECT_EQ(ports("Repeat"), "num_cycles");
  EXPECT_EQ(ports("RetryUntilSuccessful"), "num_attempts");
  EXPECT_EQ(ports("Delay"), "delay_msec");
  EXPECT_EQ(ports("Timeout"), "msec");
  EXPECT_EQ(ports("RunOnce"), "then_skip=true");
  EXPECT_EQ(ports("LoopDouble"), "queue if_empty=SUCCESS value?");
  EXPECT_EQ(ports("Precondition"), "if else=FAILURE");
  EXPECT_EQ(ports("SkipUnlessUpdated"), "entry");
  EXPECT_EQ(ports("WaitValueUpdate"), "entry");
}

TEST(BuiltInDecorators, HaveThePortsOfNav2) {
  const PortsOf ports(BuiltInDecorators());
  EXPECT_EQ(ports("RateController"), "hz=10");
}

}  // namespace
}  // namespace coppice
