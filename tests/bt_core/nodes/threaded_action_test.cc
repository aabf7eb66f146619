#include "bt_core/nodes/threaded_action.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <functional>
#include <future>
#include <thread>

#include "bt_core/testing/leaf_harness.h"

namespace coppice {
namespace {

using std::chrono::hours;

class Square : public ThreadedAction {
 public:
  static constexpr const char* kDescription = "Squares a number.";
  Input<int> number{this, "number", "what"};
  Output<int> square{this, "square", "its square"};
  Output<bool> own_thread{this, "own_thread", "Work was not on the ticking thread"};
  Output<std::string> name{this, "thread", "name of the thread"};

 private:
  void Prepare() override { number_ = *number; }
  Status Work(const StopToken&) override {
    number_ *= number_;
    worker_ = std::this_thread::get_id();
    char buffer[16];
    pthread_getname_np(pthread_self(), buffer, sizeof(buffer));
    name_ = buffer;
    return Status::kSuccess;
  }
  void Finish() override {
    square.Set(number_);
    own_thread.Set(worker_ != std::this_thread::get_id());
    name.Set(name_);
  }
  const char* thread_name() const override { return "squares"; }

  int number_ = 0;
  std::thread::id worker_;
  std::string name_;
};

TEST(ThreadedAction, WorksOnANamedThreadOfItsOwn) {
  LeafHarness harness = LeafHarness::For<Square>();
  harness.Set("number", 7);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.TickUntilDone(), Status::kSuccess);
  EXPECT_EQ(harness.Get<int>("square"), 49);
  EXPECT_TRUE(harness.Get<bool>("own_thread"));
  EXPECT_EQ(harness.Get<std::string>("thread"), "squares");
}

TEST(ThreadedAction, WorksAgainInTheNextActivation) {
  LeafHarness harness = LeafHarness::For<Square>();
  for (int i = 0; i < 100; ++i) {
    harness.Set("number", i);
    ASSERT_EQ(harness.TickUntilDone(), Status::kSuccess);
    ASSERT_EQ(harness.Get<int>("square"), i * i);
  }
}

TEST(ThreadedAction, APreparationThatFailsStartsNoWork) {
  LeafHarness harness = LeafHarness::For<Square>();
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_NE(harness.message().find(R"("number")"), std::string::npos) << harness.message();
}

using Job = std::function<Status(const StopToken&)>;

class Does : public ThreadedAction {
 public:
  static constexpr const char* kDescription = "Does what the test says.";
  explicit Does(Job job) : job_(std::move(job)) {}

 private:
  Status Work(const StopToken& stop) override { return job_(stop); }
  Job job_;
};

TEST(ThreadedAction, WhatWorkThrowsIsTheReasonOfTheFailure) {
  LeafHarness harness = LeafHarness::For<Does>(
      Job([](const StopToken&) -> Status { throw std::runtime_error("no map"); }));
  EXPECT_EQ(harness.TickUntilDone(), Status::kFailure);
  EXPECT_EQ(harness.message(), "no map");
}

TEST(ThreadedAction, WhatIsNoExceptionOfTheLibraryIsAFailureToo) {
  LeafHarness harness = LeafHarness::For<Does>(Job([](const StopToken&) -> Status { throw 1; }));
  EXPECT_EQ(harness.TickUntilDone(), Status::kFailure);
  EXPECT_NE(harness.message(), "");
}

TEST(ThreadedAction, WorkMustEndWithAResult) {
  LeafHarness harness =
      LeafHarness::For<Does>(Job([](const StopToken&) { return Status::kRunning; }));
  EXPECT_EQ(harness.TickUntilDone(), Status::kFailure);
  EXPECT_EQ(harness.message(), "Work returned RUNNING");
}

TEST(ThreadedAction, WorkMaySkip) {
  LeafHarness harness =
      LeafHarness::For<Does>(Job([](const StopToken&) { return Status::kSkipped; }));
  EXPECT_EQ(harness.TickUntilDone(), Status::kSkipped);
}

TEST(ThreadedAction, HaltingRequestsTheStopAndDoesNotWait) {
  std::promise<void> stopped;
  std::promise<void> may_end;
  LeafHarness harness = LeafHarness::For<Does>(Job([&](const StopToken& stop) {
    stop.WaitFor(hours(1));
    stopped.set_value();
    may_end.get_future().wait();
    return Status::kFailure;
  }));
  harness.Tick();
  harness.Halt();  // would never return if it waited for Work
  stopped.get_future().wait();
  may_end.set_value();
  EXPECT_TRUE(harness.WaitUntilStopped());
}

TEST(ThreadedAction, ANewActivationWaitsForTheOldWork) {
  std::atomic<int> at_once{0};
  std::atomic<int> runs{0};
  std::promise<void> may_end;
  std::shared_future<void> end = may_end.get_future().share();
  LeafHarness harness = LeafHarness::For<Does>(Job([&, end](const StopToken&) {
    const bool alone = ++at_once == 1;
    if (++runs == 1) end.wait();
    --at_once;
    return alone ? Status::kSuccess : Status::kFailure;
  }));
  harness.Tick();
  harness.Halt();
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  harness.Advance(hours(1));  // the engine gives it up, the action does not
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_LE(runs, 1);
  may_end.set_value();
  EXPECT_EQ(harness.TickUntilDone(), Status::kSuccess);
  EXPECT_EQ(runs, 2);
}

TEST(ThreadedAction, TheResultOfAHaltedActivationIsNeverSeen) {
  std::atomic<int> runs{0};
  LeafHarness harness = LeafHarness::For<Does>(Job([&](const StopToken& stop) {
    if (++runs > 1) return Status::kSuccess;
    stop.WaitFor(hours(1));
    return Status::kFailure;
  }));
  harness.Tick();
  harness.Halt();
  EXPECT_EQ(harness.TickUntilDone(), Status::kSuccess);
}

TEST(ThreadedAction, TheTreeEndsOnlyAfterTheWork) {
  std::atomic<bool> done{false};
  std::promise<void> begun;
  std::string text(1000, 'x');  // belongs to the job: the sanitizers see a use after its end
  {
    LeafHarness harness = LeafHarness::For<Does>(Job([&done, &begun, text](const StopToken& stop) {
      begun.set_value();
      stop.WaitFor(hours(1));
      done = text.size() == 1000;
      return Status::kSuccess;
    }));
    harness.Tick();
    begun.get_future().wait();
  }
  EXPECT_TRUE(done);
}

}  // namespace
}  // namespace coppice
