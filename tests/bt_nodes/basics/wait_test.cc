#include "bt_nodes/basics/wait.h"

#include <gtest/gtest.h>

#include <limits>

#include "bt_core/testing/leaf_harness.h"

namespace coppice::leaves {
namespace {

using std::chrono::milliseconds;

TEST(Wait, RunsUntilTheTimeHasPassed) {
  LeafHarness harness = LeafHarness::For<Wait>();
  harness.Set("seconds", 2.0);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  harness.Advance(milliseconds(1999));
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  harness.Advance(milliseconds(1));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(Wait, AsksToBeWokenWhenTheTimeHasPassed) {
  LeafHarness harness = LeafHarness::For<Wait>();
  harness.Set("seconds", 2.0);
  harness.Tick();
  EXPECT_EQ(harness.next_tick(), Time(std::chrono::seconds(2)));
}

TEST(Wait, SucceedsAtOnceForZeroSeconds) {
  LeafHarness harness = LeafHarness::For<Wait>();
  harness.Set("seconds", 0.0);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(Wait, StartsAnewAfterBeingHalted) {
  LeafHarness harness = LeafHarness::For<Wait>();
  harness.Set("seconds", 2.0);
  harness.Tick();
  harness.Advance(milliseconds(1500));
  harness.Halt();
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  harness.Advance(milliseconds(1500));
  EXPECT_EQ(harness.Tick(), Status::kRunning);
}

TEST(Wait, FailsForATimeThatIsNoNumber) {
  LeafHarness harness = LeafHarness::For<Wait>();
  harness.Set("seconds", std::numeric_limits<double>::infinity());
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "seconds must be a finite number");
}

}  // namespace
}  // namespace coppice::leaves
