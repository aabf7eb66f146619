#include "bt_core/nodes/threaded_action.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <stdexcept>
#include <utility>

#include "bt_core/testing/leaf_harness.h"

namespace coppice {
namespace {

// [measure]
class MeasureLight : public ThreadedAction {
 public:
  static constexpr const char* kDescription = "Measures the brightness with a slow sensor.";
  using Sensor = std::function<double()>;
  explicit MeasureLight(Sensor read) : read_(std::move(read)) {}
  Input<int> samples{this, "samples", "how many are averaged", 8};
  Output<double> lux{this, "lux", "brightness [lx]"};

 private:
  void Prepare() override {
    if (*samples < 1) throw std::invalid_argument("needs at least one sample");
    count_ = *samples;
  }

  Status Work(const StopToken& stop) override {
    double sum = 0;
    for (int i = 0; i < count_; ++i) {
      if (stop.stop_requested()) return Status::kFailure;
      sum += read_();
    }
    average_ = sum / count_;
    return Status::kSuccess;
  }

  void Finish() override { lux.Set(average_); }

  Sensor read_;
  int count_ = 0;
  double average_ = 0;
};
// [measure end]

// [test]
TEST(MeasureLight, WritesTheAverage) {
  LeafHarness harness =
      LeafHarness::For<MeasureLight>(MeasureLight::Sensor([n = 0]() mutable { return ++n; }));
  harness.Set("samples", 3);
  EXPECT_EQ(harness.TickUntilDone(), Status::kSuccess);
  EXPECT_EQ(harness.Get<double>("lux"), 2.0);
}

TEST(MeasureLight, DoesNotStartWithoutSamples) {
  LeafHarness harness = LeafHarness::For<MeasureLight>(MeasureLight::Sensor([] { return 1.0; }));
  harness.Set("samples", 0);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "needs at least one sample");
}

TEST(MeasureLight, StopsReadingWhenItIsHalted) {
  std::atomic<int> reads{0};
  LeafHarness harness =
      LeafHarness::For<MeasureLight>(MeasureLight::Sensor([&reads] { return ++reads; }));
  harness.Set("samples", 2'000'000'000);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  harness.Halt();
  EXPECT_TRUE(harness.WaitUntilStopped());
  EXPECT_LT(reads, 2'000'000'000);
}
// [test end]

}  // namespace
}  // namespace coppice
