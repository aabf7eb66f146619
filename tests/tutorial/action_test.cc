#include <gtest/gtest.h>

#include <chrono>
#include <functional>

#include "bt_core/testing/leaf_harness.h"
#include "tests/tutorial/room.h"

namespace coppice {
namespace {

// [flash]
class Flash : public Action {
 public:
  static constexpr const char* kDescription = "Lights the lamp for some time.";
  explicit Flash(Lamp& lamp) : lamp_(lamp) {}
  Input<int> msec{this, "msec", "for how long [ms]"};

  Status OnStart() override {
    end_ = now() + std::chrono::milliseconds(*msec);
    lamp_.is_on = true;
    return OnRunning();
  }

  Status OnRunning() override {
    if (now() < end_) {
      WakeAt(end_);
      return Status::kRunning;
    }
    lamp_.is_on = false;
    return Status::kSuccess;
  }

  void OnHalted() override { lamp_.is_on = false; }

 private:
  Lamp& lamp_;
  Time end_{};
};
// [flash end]

// [test]
TEST(Flash, LightsTheLampForItsTime) {
  Lamp lamp;
  LeafHarness harness = LeafHarness::For<Flash>(std::ref(lamp));
  harness.Set("msec", 500);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_TRUE(lamp.is_on);
  harness.Advance(std::chrono::milliseconds(500));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_FALSE(lamp.is_on);
}

TEST(Flash, LeavesNoLightBehindWhenItIsHalted) {
  Lamp lamp;
  LeafHarness harness = LeafHarness::For<Flash>(std::ref(lamp));
  harness.Set("msec", 500);
  harness.Tick();
  harness.Halt();
  EXPECT_FALSE(lamp.is_on);
}
// [test end]

}  // namespace
}  // namespace coppice
