// Compiled as C++20.
#include "bt_core/nodes/coroutine_action.h"

#include <gtest/gtest.h>

#include <future>
#include <optional>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_core/counting_new.h"

namespace coppice {
namespace {

using std::chrono::seconds;

// Notes its end.
class Guard {
 public:
  Guard(std::vector<std::string>& log, std::string name) : log_(log), name_(std::move(name)) {}
  Guard(const Guard&) = delete;
  ~Guard() { log_.push_back(name_); }

 private:
  std::vector<std::string>& log_;
  std::string name_;
};

class Sleeps : public CoroutineAction {
 public:
  static constexpr const char* kDescription = "Sleeps twice.";
  explicit Sleeps(std::vector<std::string>* log = nullptr) : log_(log ? *log : own_) {}
  Output<int> stage{this, "stage", "how far it is"};

 private:
  Steps Run() override {
    const Guard outer(log_, "outer");
    stage.Set(1);
    co_await Sleep(seconds(1));
    stage.Set(2);
    const Guard inner(log_, "inner");
    co_await Sleep(seconds(2));
    stage.Set(3);
    co_return Status::kSuccess;
  }
  std::vector<std::string> own_;
  std::vector<std::string>& log_;
};

TEST(CoroutineAction, RunsFromWaitToWait) {
  LeafHarness harness = LeafHarness::For<Sleeps>();
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.Get<int>("stage"), 1);
  EXPECT_EQ(harness.next_tick(), Time(seconds(1)));
  harness.Advance(seconds(1));
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.Get<int>("stage"), 2);
  EXPECT_EQ(harness.next_tick(), Time(seconds(3)));
  harness.Advance(seconds(2));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<int>("stage"), 3);
}

TEST(CoroutineAction, ATickInBetweenChangesNothing) {
  LeafHarness harness = LeafHarness::For<Sleeps>();
  harness.Tick();
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.Get<int>("stage"), 1);
  EXPECT_EQ(harness.next_tick(), Time(seconds(1)));
}

TEST(CoroutineAction, HaltingDestroysWhatItHoldsInReverseOrder) {
  std::vector<std::string> log;
  LeafHarness harness = LeafHarness::For<Sleeps>(&log);
  harness.Tick();
  harness.Advance(seconds(1));
  harness.Tick();
  harness.Halt();
  EXPECT_EQ(log, (std::vector<std::string>{"inner", "outer"}));
}

TEST(CoroutineAction, BeginsAnewAfterAHalt) {
  LeafHarness harness = LeafHarness::For<Sleeps>();
  harness.Tick();
  harness.Advance(seconds(1));
  harness.Tick();
  harness.Halt();
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.Get<int>("stage"), 1);
  EXPECT_EQ(harness.TickUntilDone(), Status::kSuccess);
}

TEST(CoroutineAction, TheEndOfTheTreeDestroysWhatItHolds) {
  std::vector<std::string> log;
  {
    LeafHarness harness = LeafHarness::For<Sleeps>(&log);
    harness.Tick();
  }
  EXPECT_EQ(log, std::vector<std::string>{"outer"});
}

TEST(CoroutineAction, ATickAllocatesNothing) {
  LeafHarness harness = LeafHarness::For<Sleeps>();
  harness.TickUntilDone();  // the first activation allocates the frame
  const std::uint64_t before = Allocations();
  for (int i = 0; i < 10; ++i) {
    harness.Tick();
    harness.Advance(std::chrono::milliseconds(300));
  }
  EXPECT_EQ(Allocations() - before, 0U);
}

class Waits : public CoroutineAction {
 public:
  static constexpr const char* kDescription = "Waits for a key and yields once.";
  Input<int> level{this, "level", "what it looks at"};
  Output<int> asked{this, "asked", "how often it looked"};

 private:
  Steps Run() override {
    int count = 0;
    co_await Until([&] {
      asked.Set(++count);
      return *level > 10;
    });
    co_await Yield();
    co_return Status::kFailure;
  }
};

TEST(CoroutineAction, WaitsUntilAPredicateIsTrue) {
  LeafHarness harness = LeafHarness::For<Waits>();
  harness.Set("level", 1);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.next_tick(), kNever);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.Get<int>("asked"), 2);
  harness.Set("level", 11);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.Get<int>("asked"), 3);
  EXPECT_LE(harness.next_tick(), Time{});  // a yield asks for the next tick at once
  EXPECT_EQ(harness.Tick(), Status::kFailure);
}

TEST(CoroutineAction, AWaitThatIsOverAtOnceDoesNotWait) {
  LeafHarness harness = LeafHarness::For<Waits>();
  harness.Set("level", 11);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.Get<int>("asked"), 1);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
}

TEST(CoroutineAction, AnExceptionOfThePredicateFailsTheAction) {
  LeafHarness harness = LeafHarness::For<Waits>();
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_NE(harness.message().find(R"("level")"), std::string::npos) << harness.message();
}

// Throws when it is told to, at once or later.
class Throws : public CoroutineAction {
 public:
  static constexpr const char* kDescription = "Throws.";
  Throws(std::vector<std::string>* log, int* where) : log_(*log), where_(*where) {}

 private:
  Steps Run() override {
    const Guard guard(log_, "guard");
    if (where_ == 0) throw std::runtime_error("at once");
    co_await Until([this] {
      if (where_ == 1) throw std::runtime_error("in the predicate");
      return where_ != 3;
    });
    if (where_ == 2) throw std::runtime_error("later");
    co_return Status::kSuccess;
  }
  std::vector<std::string>& log_;
  int& where_;
};

TEST(CoroutineAction, AnExceptionIsTheReasonOfTheFailureAndDestroysWhatItHolds) {
  std::vector<std::string> log;
  int where = 0;
  LeafHarness harness = LeafHarness::For<Throws>(&log, &where);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "at once");
  for (const auto& [place, text] : {std::pair(1, "in the predicate"), std::pair(2, "later")}) {
    log.clear();
    where = 3;
    ASSERT_EQ(harness.Tick(), Status::kRunning);
    where = place;
    EXPECT_EQ(harness.Tick(), Status::kFailure);
    EXPECT_EQ(harness.message(), text);
    EXPECT_EQ(log, std::vector<std::string>{"guard"});
  }
  where = 4;
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

class Asks : public CoroutineAction {
 public:
  static constexpr const char* kDescription = "Asks twice and adds the answers.";
  explicit Asks(Sender<int>* asked) : asked_(*asked) {}
  Mailbox<int> answer{this, "answer"};
  Output<int> sum{this, "sum", "of both answers"};

 private:
  Steps Run() override {
    asked_ = answer.NewSender();
    const int first = co_await Receive(answer);
    asked_ = answer.NewSender();
    sum.Set(first + co_await Receive(answer));
    co_return Status::kSuccess;
  }
  Sender<int>& asked_;
};

TEST(CoroutineAction, ReceivesMessages) {
  Sender<int> asked;
  LeafHarness harness = LeafHarness::For<Asks>(&asked);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  const Sender<int> first = asked;
  first.Send(40);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  first.Send(1000);  // too late: no longer asked for
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  asked.Send(2);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<int>("sum"), 42);
}

class Computes : public CoroutineAction {
 public:
  static constexpr const char* kDescription = "Waits for a future.";
  explicit Computes(std::promise<int>* promise) : promise_(*promise) {}
  Output<int> result{this, "result", "what came"};

 private:
  Steps Run() override {
    result.Set(co_await promise_.get_future());
    co_return Status::kSuccess;
  }
  std::promise<int>& promise_;
};

TEST(CoroutineAction, WaitsForAFuture) {
  std::promise<int> promise;
  LeafHarness harness = LeafHarness::For<Computes>(&promise);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  promise.set_value(5);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<int>("result"), 5);
}

TEST(CoroutineAction, TheExceptionOfAFutureFailsTheAction) {
  std::promise<int> promise;
  LeafHarness harness = LeafHarness::For<Computes>(&promise);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  promise.set_exception(std::make_exception_ptr(std::runtime_error("broken")));
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "broken");
}

}  // namespace
}  // namespace coppice
