#include "bt_core/nodes/leaf.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace coppice {
namespace {

class Host : public LeafHost {
 public:
  void AddMessage(std::string text) override { messages.push_back(std::move(text)); }
  void set_now(Time now) { now_ = now; }
  Time wake_at() const { return wake_at_; }
  std::vector<std::string> messages;
  void Drain(Duration) override {}
};

class Dark : public Condition {
 public:
  bool Check() override { return dark; }
  bool dark = true;
};

class Once : public SyncAction {
 public:
  Status Run() override { return Status::kSkipped; }
};

class Drive : public Action {
 public:
  Status OnStart() override {
    calls += "start ";
    WakeAt(now() + std::chrono::seconds(2));
    return Status::kRunning;
  }
  Status OnRunning() override {
    calls += "running ";
    Say("driving");
    return Fail("blocked");
  }
  void OnHalted() override { calls += "halted "; }
  std::string calls;
};

TEST(Condition, MapsTheAnswerToAStatus) {
  Dark dark;
  EXPECT_EQ(dark.Tick(true), Status::kSuccess);
  dark.dark = false;
  EXPECT_EQ(dark.Tick(true), Status::kFailure);
}

TEST(SyncAction, ReturnsWhatRunReturns) { EXPECT_EQ(Once().Tick(true), Status::kSkipped); }

TEST(SyncAction, HaltingDoesNothing) { Once().Halt(); }

TEST(Action, StartsOnceThenRuns) {
  Host host;
  Drive drive;
  drive.set_host(&host);
  EXPECT_EQ(drive.Tick(true), Status::kRunning);
  EXPECT_EQ(drive.Tick(false), Status::kFailure);
  drive.Halt();
  EXPECT_EQ(drive.calls, "start running halted ");
}

TEST(Leaf, FailSaysWhy) {
  Host host;
  Drive drive;
  drive.set_host(&host);
  drive.Tick(false);
  EXPECT_EQ(host.messages, (std::vector<std::string>{"driving", "blocked"}));
}

TEST(Leaf, AsksForATickInTheTreesTime) {
  Host host;
  host.set_now(Time(std::chrono::seconds(10)));
  Drive drive;
  drive.set_host(&host);
  drive.Tick(true);
  EXPECT_EQ(host.wake_at(), Time(std::chrono::seconds(12)));
}

TEST(LeafHost, KeepsTheEarliestWakeUp) {
  Host host;
  host.WakeAt(Time(std::chrono::seconds(5)));
  host.WakeAt(Time(std::chrono::seconds(3)));
  host.WakeAt(Time(std::chrono::seconds(4)));
  EXPECT_EQ(host.wake_at(), Time(std::chrono::seconds(3)));
}

}  // namespace
}  // namespace coppice
