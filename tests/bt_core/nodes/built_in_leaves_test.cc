// The names, ports and defaults of the peer's nodes (BehaviorTree.CPP 4).
#include <gtest/gtest.h>

#include "bt_core/nodes/built_in_tables.h"
#include "tests/bt_core/nodes/ports_of.h"

namespace coppice {
namespace {

TEST(BuiltInLeaves, HaveThePortsOfThePeer) {
  const PortsOf ports(BuiltInLeaves());
  EXPECT_EQ(ports("AlwaysSuccess"), "");
  EXPECT_EQ(ports("Sleep"), "msec");
  EXPECT_EQ(ports("Script"), "code");
  EXPECT_EQ(ports("ScriptCondition"), "code");
  EXPECT_EQ(ports("SetBlackboard"), "value output_key");
  EXPECT_EQ(ports("UnsetBlackboard"), "key");
  EXPECT_EQ(ports("WasEntryUpdated"), "entry");
}

}  // namespace
}  // namespace coppice
