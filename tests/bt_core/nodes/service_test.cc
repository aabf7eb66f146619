#include "bt_core/nodes/service.h"

#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"

namespace coppice {
namespace {

using std::chrono::milliseconds;
using Log = std::vector<std::string>;

class Watch : public Service {
 public:
  static constexpr const char* kDescription = "Notes what it is asked to do.";
  explicit Watch(Log* log) : log_(*log) {}

 private:
  void OnEnter() override { log_.emplace_back("enter"); }
  void OnPeriod() override {
    log_.push_back("at " + std::to_string(now().time_since_epoch() / milliseconds(1)));
    if (log_.size() > 4) throw std::runtime_error("worn out");
  }
  void OnExit() override { log_.emplace_back("exit"); }
  Log& log_;
};

class ServiceTest : public testing::Test {
 protected:
  Log log_;
  LeafHarness harness_ = LeafHarness::WithChildren<Watch>(1, &log_);
};

TEST_F(ServiceTest, RunsAtTheStartAndThenAtItsPeriod) {
  harness_.Set("period_msec", 100U);
  harness_.SetChild(0, {Status::kRunning});
  EXPECT_EQ(harness_.Tick(), Status::kRunning);
  EXPECT_EQ(harness_.next_tick(), Time(milliseconds(100)));
  harness_.Advance(milliseconds(99));
  harness_.Tick();
  EXPECT_EQ(log_, (Log{"enter", "at 0"}));
  harness_.Advance(milliseconds(1));
  harness_.Tick();
  EXPECT_EQ(log_, (Log{"enter", "at 0", "at 100"}));
  EXPECT_EQ(harness_.next_tick(), Time(milliseconds(200)));
}

TEST_F(ServiceTest, KeepsItsRhythmAndLeavesOutWhatItMissed) {
  harness_.Set("period_msec", 100U);
  harness_.SetChild(0, {Status::kRunning});
  harness_.Tick();
  harness_.Advance(milliseconds(350));
  harness_.Tick();
  EXPECT_EQ(log_, (Log{"enter", "at 0", "at 350"}));
  EXPECT_EQ(harness_.next_tick(), Time(milliseconds(400)));
}

TEST_F(ServiceTest, APeriodOf0IsEveryTick) {
  harness_.Set("period_msec", 0U);
  harness_.SetChild(0, {Status::kRunning});
  harness_.Tick();
  harness_.Tick();
  EXPECT_EQ(log_, (Log{"enter", "at 0", "at 0"}));
  EXPECT_EQ(harness_.next_tick(), kNever);
}

TEST_F(ServiceTest, ReturnsWhatItsChildReturns) {
  for (const Status status : {Status::kSuccess, Status::kFailure, Status::kSkipped}) {
    log_.clear();
    harness_.SetChild(0, {status});
    EXPECT_EQ(harness_.Tick(), status);
    EXPECT_EQ(log_, (Log{"enter", "at 0", "exit"}));
  }
}

TEST_F(ServiceTest, AHaltExitsBeforeTheChildIsHalted) {
  harness_.SetChild(0, {Status::kRunning});
  harness_.Tick();
  harness_.Halt();
  EXPECT_EQ(log_, (Log{"enter", "at 0", "exit"}));
  EXPECT_EQ(harness_.TakeChildEvents(), (Log{"start 0", "halt 0"}));
}

TEST_F(ServiceTest, AnExceptionExitsAndHaltsTheChild) {
  harness_.Set("period_msec", 0U);
  harness_.SetChild(0, {Status::kRunning});
  Status status = Status::kRunning;
  while (status == Status::kRunning) status = harness_.Tick();
  EXPECT_EQ(status, Status::kFailure);
  EXPECT_EQ(harness_.message(), "worn out");
  EXPECT_EQ(log_, (Log{"enter", "at 0", "at 0", "at 0", "at 0", "exit"}));
  EXPECT_EQ(harness_.TakeChildEvents().back(), "halt 0");
}

}  // namespace
}  // namespace coppice
