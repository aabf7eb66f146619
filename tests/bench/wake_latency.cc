#include "tests/bench/wake_latency.h"

#include <algorithm>
#include <atomic>
#include <random>
#include <thread>

#include "bt_core/engine/runner.h"
#include "tests/bench/bench_leaves.h"
#include "tests/bench/tree_texts.h"

namespace coppice::bench {
namespace {

Time SteadyNow() { return Time(std::chrono::steady_clock::now().time_since_epoch()); }

constexpr char kSleepingTree[] =
    R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><ReactiveFallback>)"
    R"(<CondPort value="{battery}" threshold="-1"/><RunForever/>)"
    "</ReactiveFallback></BehaviorTree></root>";

// Sees every tick from within: when it began, and how often the key was written so far.
class TickWatch : public TickSink {
 public:
  TickWatch(const Executor& executor, SlotIndex slot) : executor_(executor), slot_(slot) {}
  void OnTick(const TickEvents& events) override {
    start = events.start;
    writes.store(executor_.blackboard()[slot_].writes, std::memory_order_release);
  }
  Time start{};  // of the newest tick; published by `writes`
  std::atomic<std::uint32_t> writes{0};

 private:
  const Executor& executor_;
  SlotIndex slot_;
};

// A tree on a thread of its own that sleeps until a message comes.
class SleepingTree {
 public:
  SleepingTree()
      : executor(Load(kSleepingTree), clock),
        battery(executor.Writer<double>("battery")),
        watch(executor, executor.program().layout.Find(kMainScope, "battery")),
        runner_(executor, {Pace::kEvents, kForever}) {
    executor.AddSink(&watch);
    battery.Send(80);
    thread_ = std::thread([this] { runner_.Run(); });
    Await(1);
  }
  ~SleepingTree() {
    runner_.Stop();
    thread_.join();
    executor.RemoveSink(&watch);
  }

  // True when the tree has seen so many posts; false after ten seconds without.
  bool Await(std::uint32_t posts) {
    const Time deadline = SteadyNow() + std::chrono::seconds(10);
    while (watch.writes.load(std::memory_order_acquire) < posts) {
      if (SteadyNow() > deadline) return false;
    }
    return true;
  }

  WallClock clock;
  Executor executor;
  Sender<double> battery;
  TickWatch watch;

 private:
  Runner runner_;
  std::thread thread_;
};

}  // namespace

std::vector<Duration> WakeLatencies(int posts, Duration gap) {
  SleepingTree tree;
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int64_t> gaps(0, gap.count());
  std::vector<Duration> latencies;
  latencies.reserve(static_cast<std::size_t>(posts));
  for (int i = 0; i < posts; ++i) {
    const Time until = SteadyNow() + Duration(gaps(random));
    while (SteadyNow() < until) {
    }
    const Time sent = tree.clock.Now();
    tree.battery.Send(i);
    if (!tree.Await(static_cast<std::uint32_t>(i) + 2)) break;
    latencies.push_back(tree.watch.start - sent);
  }
  std::sort(latencies.begin(), latencies.end());
  return latencies;
}

std::uint64_t LostPosts(std::uint64_t posts) {
  constexpr std::uint64_t kThreads = 4;
  SleepingTree tree;
  std::vector<std::thread> posters;
  for (std::uint64_t t = 0; t < kThreads; ++t) {
    posters.emplace_back([&tree, count = posts / kThreads] {
      for (std::uint64_t i = 0; i < count; ++i) tree.battery.Send(static_cast<double>(i));
    });
  }
  for (std::thread& poster : posters) poster.join();
  tree.Await(static_cast<std::uint32_t>(posts / kThreads * kThreads + 1));
  return posts / kThreads * kThreads + 1 - tree.watch.writes;
}

}  // namespace coppice::bench
