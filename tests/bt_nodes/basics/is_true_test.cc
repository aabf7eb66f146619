#include "bt_nodes/basics/is_true.h"

#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"

namespace coppice::leaves {
namespace {

TEST(IsTrue, HoldsOnlyForAKeyThatIsTrue) {
  LeafHarness leaf = LeafHarness::For<IsTrue>();
  EXPECT_EQ(leaf.Tick(), Status::kFailure);
  leaf.Set("value", false);
  EXPECT_EQ(leaf.Tick(), Status::kFailure);
  leaf.Set("value", true);
  EXPECT_EQ(leaf.Tick(), Status::kSuccess);
}

}  // namespace
}  // namespace coppice::leaves
