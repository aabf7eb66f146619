#include <gtest/gtest.h>

#include <functional>

#include "bt_core/testing/leaf_harness.h"
#include "tests/tutorial/room.h"

namespace coppice {
namespace {

// [test]
TEST(SwitchOn, SwitchesTheLampOn) {
  Lamp lamp;
  LeafHarness harness = LeafHarness::For<SwitchOn>(std::ref(lamp));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_TRUE(lamp.is_on);
}
// [test end]

}  // namespace
}  // namespace coppice
