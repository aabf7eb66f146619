// How late a client on the same computer learns of a tick, and how soon it is back after the robot
// was started again.
//
//   coppice_live_bench
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "bt_core/engine/events/event_stream.h"
#include "bt_core/live/client/client.h"
#include "bt_core/live/server/live_publisher.h"
#include "bt_core/nodes/leaf.h"
#include "tests/bench/tree_texts.h"

namespace coppice::bench {
namespace {

constexpr int kTicks = 3000;
constexpr auto kPeriod = std::chrono::milliseconds(2);
constexpr int kRestarts = 20;

/// Mostly succeeds, so that there is something to tell in every tick.
class Noisy : public SyncAction {
 public:
  static constexpr const char* kDescription = "Fails now and then.";
  Status Run() override { return random_() % 100 == 0 ? Status::kFailure : Status::kSuccess; }

 private:
  static std::minstd_rand random_;
};
std::minstd_rand Noisy::random_{5};

std::shared_ptr<const Program> CompileNoisy() {
  auto registry = std::make_shared<Registry>();
  registry->Register<Noisy>("CondOk");
  registry->Register<Noisy>("ActOk");
  Diagnostics diagnostics;
  auto project = Project::FromText(FullTree(4, 1000), "bench.xml", diagnostics);
  return Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
}

class Robot {
 public:
  Robot(Clock& clock, std::uint16_t port)
      : executor_(CompileNoisy(), clock), live_(stream_, AtPort(port)) {}

  void Tick() { executor_.Tick(); }
  std::uint16_t port() const { return live_.port(); }

 private:
  static LiveOptions AtPort(std::uint16_t port) {
    LiveOptions options;
    options.port = port;
    return options;
  }

  Executor executor_;
  EventStream stream_{executor_};
  LivePublisher live_;
};

/// Notes how late every tick is told of, from its end.
class Observer : public LiveListener {
 public:
  explicit Observer(const Clock& clock) : clock_(clock) {}

  void OnConnection(const LiveConnection& connection) override { is_live_ = connection.is_live; }
  void OnTree(const TreeDescription&) override {}
  void OnState(const HistoryState&) override {}
  void OnTick(const TickEvents& tick) override {
    const Time now = clock_.Now();
    const std::lock_guard<std::mutex> lock(mutex_);
    milliseconds_.push_back(static_cast<double>((now - tick.start - tick.duration).count()) * 1e-6);
  }
  void OnGap(const HistoryGap& gap) override { lost_ += gap.lost_ticks; }

  bool is_live() const { return is_live_; }
  std::uint64_t lost() const { return lost_; }
  std::vector<double> milliseconds() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return milliseconds_;
  }

 private:
  const Clock& clock_;
  mutable std::mutex mutex_;
  std::vector<double> milliseconds_;
  std::atomic<bool> is_live_{false};
  std::atomic<std::uint64_t> lost_{0};
};

void Print(const char* what, std::vector<double> milliseconds) {
  std::sort(milliseconds.begin(), milliseconds.end());
  const auto at = [&](double part) {
    return milliseconds[static_cast<std::size_t>(part * static_cast<double>(milliseconds.size()))];
  };
  std::printf("%s: median %.2f ms, p99 %.2f ms, worst %.2f ms of %zu\n", what, at(0.5), at(0.99),
              milliseconds.back(), milliseconds.size());
}

void AwaitLive(const Observer& observer, bool is_live) {
  while (observer.is_live() != is_live) std::this_thread::sleep_for(std::chrono::microseconds(50));
}

void MeasureLatency(Clock& clock) {
  Robot robot(clock, 0);
  Observer observer(clock);
  const LiveClient client("127.0.0.1:" + std::to_string(robot.port()), observer);
  AwaitLive(observer, true);
  auto next = std::chrono::steady_clock::now();
  for (int i = 0; i < kTicks; ++i) {
    robot.Tick();
    std::this_thread::sleep_until(next += kPeriod);
  }
  Print("tick of 1 000 nodes at 500 Hz, from its end to the client", observer.milliseconds());
  std::printf("ticks that the client was told are lost: %llu\n",
              static_cast<unsigned long long>(observer.lost()));
}

void MeasureReconnection(Clock& clock) {
  auto robot = std::make_unique<Robot>(clock, 0);
  const std::uint16_t port = robot->port();
  Observer observer(clock);
  const LiveClient client("127.0.0.1:" + std::to_string(port), observer);
  AwaitLive(observer, true);
  std::vector<double> milliseconds;
  for (int i = 0; i < kRestarts; ++i) {
    robot.reset();
    AwaitLive(observer, false);
    robot = std::make_unique<Robot>(clock, port);
    const Time start = clock.Now();
    AwaitLive(observer, true);
    milliseconds.push_back(static_cast<double>((clock.Now() - start).count()) * 1e-6);
  }
  Print("from a restart of the robot to the view", milliseconds);
}

}  // namespace
}  // namespace coppice::bench

int main() {
  coppice::WallClock clock;
  coppice::bench::MeasureLatency(clock);
  coppice::bench::MeasureReconnection(clock);
}
