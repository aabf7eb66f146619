#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bt_core/nodes/user_control.h"
#include "bt_core/testing/leaf_harness.h"

namespace coppice {
namespace {

// [majority]
class Majority : public UserControl {
 public:
  static constexpr const char* kDescription = "Ticks all children; more than half must succeed.";

  Status Tick(Children& children, bool) override {
    std::uint32_t yes = 0;
    bool waits = false;
    for (std::uint32_t k = 0; k < children.size(); ++k) {
      Status status = children.status(k);
      if (!IsCompleted(status)) status = children.Tick(k);
      if (status == Status::kSuccess) ++yes;
      if (status == Status::kRunning) waits = true;
    }
    if (2 * yes > children.size()) return Status::kSuccess;
    return waits ? Status::kRunning : Status::kFailure;
  }
};
// [majority end]

// [test]
TEST(Majority, SucceedsWithMoreThanHalfAndHaltsTheRest) {
  LeafHarness harness = LeafHarness::WithChildren<Majority>(3);
  harness.SetChild(0, {Status::kRunning});
  harness.SetChild(1, {Status::kRunning, Status::kSuccess});
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  harness.TakeChildEvents();
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.TakeChildEvents(), (std::vector<std::string>{"tick 0", "tick 1", "halt 0"}));
}

TEST(Majority, FailsWithoutOne) {
  LeafHarness harness = LeafHarness::WithChildren<Majority>(2);
  harness.SetChild(0, {Status::kFailure});
  EXPECT_EQ(harness.Tick(), Status::kFailure);
}
// [test end]

}  // namespace
}  // namespace coppice
