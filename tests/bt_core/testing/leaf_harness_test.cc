#include "bt_core/testing/leaf_harness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

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
    return OnRunning();
  }
  Status OnRunning() override {
    WakeAt(end_);
    if (now() < end_) return Status::kRunning;
    waited.Set(*time);
    return Status::kSuccess;
  }
  void OnHalted() override { Say("stopped " + *label); }

 private:
  Time end_{};
};

TEST(LeafHarness, RunsALeafOnSimulatedTime) {
  LeafHarness harness = LeafHarness::For<Wait>();
  harness.Set("seconds", 2.0);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.next_tick(), Time(seconds(2)));
  EXPECT_FALSE(harness.WasWritten("waited"));
  harness.Advance(seconds(2));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<double>("waited"), 2.0);
}

TEST(LeafHarness, AnInputThatIsNotSetFailsTheLeaf) {
  LeafHarness harness = LeafHarness::For<Wait>();
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_NE(harness.message().find(R"("seconds")"), std::string::npos) << harness.message();
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
  EXPECT_THROW(LeafHarness(std::make_shared<Registry>(), "Wait"), std::invalid_argument);
  EXPECT_THROW(LeafHarness(std::make_shared<Registry>(), "Inverter", 2), std::invalid_argument);
}

TEST(LeafHarness, MovesTheTimeUntilTheLeafIsDone) {
  LeafHarness harness = LeafHarness::For<Wait>();
  harness.Set("seconds", 3600.0);
  EXPECT_EQ(harness.TickUntilDone(), Status::kSuccess);
  EXPECT_EQ(harness.Get<double>("waited"), 3600.0);
}

// Waits for a message that another thread sends.
class WaitForMessage : public Action {
 public:
  static constexpr const char* kDescription = "Waits for a message.";
  explicit WaitForMessage(std::thread* thread) : thread_(thread) {}
  Mailbox<int> answer{this, "answer"};
  Status OnStart() override {
    *thread_ = std::thread([sender = answer.NewSender()] { sender.Send(1); });
    return Status::kRunning;
  }
  Status OnRunning() override { return answer.Take() ? Status::kSuccess : Status::kRunning; }
  void OnHalted() override {}

 private:
  std::thread* thread_;
};

TEST(LeafHarness, WaitsForMessagesOfOtherThreads) {
  std::thread thread;
  LeafHarness harness = LeafHarness::For<WaitForMessage>(&thread);
  EXPECT_EQ(harness.TickUntilDone(), Status::kSuccess);
  thread.join();
}

// Waits for what never comes.
class WaitForever : public Action {
 public:
  static constexpr const char* kDescription = "Waits for ever.";
  Status OnStart() override { return Status::kRunning; }
  Status OnRunning() override { return Status::kRunning; }
  void OnHalted() override {}
};

TEST(LeafHarness, GivesUpALeafThatNobodyWakes) {
  LeafHarness harness = LeafHarness::For<WaitForever>();
  EXPECT_EQ(harness.TickUntilDone(std::chrono::milliseconds(1)), Status::kRunning);
}

TEST(LeafHarness, ValuesOfATypeThatIsKnownLaterAreSetAndRead) {
  LeafHarness harness = LeafHarness::For<Wait>();
  EXPECT_EQ(harness.TypeOfPort("seconds"), &TypeOf<double>());
  harness.SetValue("seconds", Value(3.0));
  harness.TickUntilDone();
  EXPECT_EQ(harness.ValueOf("waited").Get<double>(), 3.0);
}

TEST(LeafHarness, AMisspeltPortIsToldWithTheRightName) {
  LeafHarness harness = LeafHarness::For<Wait>();
  try {
    harness.TypeOfPort("secnds");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("did you mean \"seconds\"?"));
  }
}

// Needs two seconds to stop.
class Brake : public Action {
 public:
  static constexpr const char* kDescription = "Drives until it is halted, then brakes.";
  Output<bool> standing{this, "standing", "it does not move"};
  Status OnStart() override { return Status::kRunning; }
  Status OnRunning() override { return Status::kRunning; }
  void OnHalted() override {
    stopped_at_ = now() + seconds(2);
    DrainFor(seconds(5));
  }
  bool OnDraining() override {
    standing.Set(now() >= stopped_at_);
    return now() >= stopped_at_;
  }

 private:
  Time stopped_at_{};
};

TEST(LeafHarness, WaitsUntilAHaltedLeafHasStopped) {
  LeafHarness harness = LeafHarness::For<Brake>();
  harness.Tick();
  harness.Halt();
  EXPECT_FALSE(harness.WasWritten("standing"));
  EXPECT_TRUE(harness.WaitUntilStopped(seconds(1)));
  EXPECT_TRUE(harness.Get<bool>("standing"));
}

TEST(LeafHarness, ChildrenDoAsTheyAreTold) {
  LeafHarness harness(std::make_shared<Registry>(), "Sequence", 3);
  harness.SetChild(1, {Status::kRunning, Status::kFailure});
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.child_status(0), Status::kSuccess);
  EXPECT_EQ(harness.child_status(1), Status::kRunning);
  EXPECT_EQ(harness.child_status(2), Status::kIdle);
  EXPECT_EQ(harness.TakeChildEvents(), (std::vector<std::string>{"start 0", "start 1"}));
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.TakeChildEvents(), std::vector<std::string>{"tick 1"});
}

TEST(LeafHarness, ChildrenAreToldThatTheyAreHalted) {
  LeafHarness harness(std::make_shared<Registry>(), "Inverter", 1);
  harness.SetChild(0, {Status::kRunning});
  harness.Tick();
  harness.Halt();
  EXPECT_EQ(harness.TakeChildEvents(), (std::vector<std::string>{"start 0", "halt 0"}));
}

TEST(LeafHarness, SetsThePortsOfBuiltInNodes) {
  LeafHarness harness(std::make_shared<Registry>(), "Delay", 1);
  harness.Set("delay_msec", 50U);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.TakeChildEvents(), std::vector<std::string>());
  EXPECT_EQ(harness.TickUntilDone(), Status::kSuccess);
}

}  // namespace
}  // namespace coppice
