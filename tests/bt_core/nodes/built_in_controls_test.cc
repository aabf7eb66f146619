// The names, ports and defaults of the peer's nodes (BehaviorTree.CPP 4).
#include <gtest/gtest.h>

#include "bt_core/nodes/built_in_tables.h"
#include "tests/bt_core/nodes/ports_of.h"

namespace coppice {
namespace {

TEST(BuiltInControls, HaveThePortsOfThePeer) {
  const PortsOf ports(BuiltInControls());
  EXPECT_EQ(ports("Sequence"), "");
  EXPECT_EQ(ports("AsyncFallback"), "");
  EXPECT_EQ(ports("SequenceWithMemory"), "");
  EXPECT_EQ(ports("IfThenElse"), "");
  EXPECT_EQ(ports("Parallel"), "success_count=-1 failure_count=1");
  EXPECT_EQ(ports("ParallelAll"), "max_failures=1");
  EXPECT_EQ(ports("Switch2"), "variable? case_1? case_2?");
  EXPECT_EQ(ports("Switch6"), "variable? case_1? case_2? case_3? case_4? case_5? case_6?");
  EXPECT_EQ(ports("TryCatch"), "catch_on_halt=false");
}

TEST(BuiltInControls, HaveThePortsOfNav2) {
  const PortsOf ports(BuiltInControls());
  EXPECT_EQ(ports("RecoveryNode"), "number_of_retries=1");
  EXPECT_EQ(ports("RoundRobin"), "wrap_around=false");
  EXPECT_EQ(ports("PersistentSequence"), "current_child_idx");
  EXPECT_EQ(ports("PipelineSequence"), "");
}

}  // namespace
}  // namespace coppice
