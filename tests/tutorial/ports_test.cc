#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"
#include "tests/tutorial/room.h"

namespace coppice {
namespace {

// [test]
TEST(IsDark, ComparesTheBrightnessWithItsLimit) {
  LeafHarness harness = LeafHarness::For<IsDark>();
  harness.Set("lux", 15.0);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  harness.Set("limit", 20.0);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(IsDark, SaysWhichValueIsMissing) {
  LeafHarness harness = LeafHarness::For<IsDark>();
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_NE(harness.message().find(R"("lux")"), std::string::npos);
}
// [test end]

}  // namespace
}  // namespace coppice
