#include "bt_core/testing/leaf_harness.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

using std::chrono::seconds;

class Wait : public Action {
 public:
  static constexpr const char* kDescription = "Waits.";
  Input<double> time{this, "seconds", "how long [s]"};
  Input<std::string> label{this, "label", "for people", std::string("none")};
  Output<double> waited{this, "waited", "how long it was [s]"};
  Status OnStart() override {
    if (*time < 0) return Fail("negative time");
    end_ = now() + Duration(static_cast<std::int64_t>(*time * 1e9));
    WakeAt(end_);
    return Status::kRunning;
  }
  Status OnRunning() override {
    if (now() < end_) return Status::kRunning;
    waited.Set(*time);
    return Status::kSuccess;
  }
  void OnHalted() override { Say("stopped " + *label); }

 private:
  Time end_{0};
};

TEST(LeafHarness, RunsALeafOnSimulatedTime) {
  LeafHarness harness = LeafHarness::For<Wait>();
  harness.Set("seconds", 2.0);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.next_tick(), seconds(2));
  EXPECT_FALSE(harness.WasWritten("waited"));
  harness.Advance(seconds(2));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<double>("waited"), 2.0);
}

TEST(LeafHarness, AnInputThatIsNotSetFailsTheLeaf) {
  LeafHarness harness = LeafHarness::For<Wait>();
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_NE(harness.message().find("\"seconds\""), std::string::npos) << harness.message();
}

TEST(LeafHarness, KeepsTheMessagesOfTheLastTick) {
  LeafHarness harness = LeafHarness::For<Wait>();
  harness.Set("seconds", -1.0);
  harness.Tick();
  EXPECT_EQ(harness.message(), "negative time");
  harness.Set("seconds", 1.0);
  harness.Tick();
  EXPECT_EQ(harness.message(), "");
}

TEST(LeafHarness, PortsKeepTheirDefaultUntilTheyAreSet) {
  LeafHarness harness = LeafHarness::For<Wait>();
  harness.Set("seconds", 1.0);
  harness.Tick();
  harness.Halt();
  EXPECT_EQ(harness.message(), "stopped none");
  harness.Set("label", std::string("hall"));
  harness.Tick();
  harness.Halt();
  EXPECT_EQ(harness.message(), "stopped hall");
}

TEST(LeafHarness, RefusesWrongNamesAndTypes) {
  LeafHarness harness = LeafHarness::For<Wait>();
  EXPECT_THROW(harness.Set("secnds", 1.0), std::invalid_argument);
  EXPECT_THROW(harness.Set("seconds", 1), std::invalid_argument);
  EXPECT_THROW(harness.Get<double>("waited"), std::out_of_range);
}

}  // namespace
}  // namespace coppice
