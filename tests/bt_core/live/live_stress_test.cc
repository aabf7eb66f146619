// Many clients, many ticks: no race (under the thread sanitizer), no stop that is never released,
// no memory that grows, no push that comes late.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include "bt_core/frames/history_decoder.h"
#include "bt_core/live/debug/debugger.h"
#include "bt_core/live/server/live_publisher.h"
#include "tests/bt_core/live/live_client.h"
#include "tests/bt_core/live/watched_tree.h"

namespace coppice {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using Json = nlohmann::json;
using SteadyClock = std::chrono::steady_clock;

#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

// Takes the pushes of one subscription apart, as a client does.
class Watcher : public HistoryHandler {
 public:
  void OnTree(const TreeDescription& tree) override { nodes = tree.nodes.size(); }
  void OnState(const HistoryState& state) override { tick = state.tick; }
  void OnTick(const TickEvents& events) override {
    if (events.is_whole && events.tick > tick + 1) ++holes;
    tick = events.tick;
  }
  void OnGap(const HistoryGap& gap) override { lost += gap.lost_ticks; }

  /// Sets `next` to the frame that follows.
  Outcome Take(const std::string& push) {
    const auto* at = reinterpret_cast<const std::uint8_t*>(push.data());
    const auto* const end = at + push.size();
    next = 0;
    for (int i = 15; i >= 8; --i) next = next << 8 | at[i];
    for (at += 16; at < end;) {
      const std::size_t size = kFrameHeaderSize + ReadFrameHeader(at).payload_size;
      if (size > static_cast<std::size_t>(end - at)) return Problem{"a frame is cut off"};
      if (Outcome decoded = decoder_.Decode(at, size, *this); !decoded) return decoded;
      at += size;
    }
    return {};
  }

  std::size_t nodes = 0;
  std::uint64_t tick = 0;
  std::uint64_t next = 0;
  std::uint64_t holes = 0;  // that no gap tells of
  std::uint64_t lost = 0;

 private:
  HistoryDecoder decoder_;
};

// What a person with a debugger may do, and what a broken program may do.
class RandomClient {
 public:
  RandomClient(std::uint16_t port, unsigned seed, const std::atomic<bool>& ends)
      : port_(port), random_(seed), ends_(ends) {}

  void Run() {
    for (; !ends_; ++connections_) {
      if (random_() % 8 == 0) {
        AskPlain();
      } else {
        Live();
      }
    }
  }

  int connections() const { return connections_; }

 private:
  void AskPlain() {
    PlainClient client(port_);
    for (const char type : std::string("TSDt")) client.Ask(type);
    client.Ask({PlainClient::Header('B'), "Main;inner"});
    client.Ask({PlainClient::Header('I'),
                R"({"enabled": true, "uid": 4, "mode": 1, "once": true,
                    "desired_status": "FAILURE", "position": 1})"});
    client.Ask({PlainClient::Header('r'), random_() % 2 ? "start" : "stop"});
    client.Ask('A');
  }

  // One connection, which ends in order or without a word.
  void Live() {
    ExtensionClient client(port_);
    client.Ask("hello", {{"name", "random"}});
    for (int i = 0; i < 20 && !ends_; ++i) Act(client);
    if (random_() % 2 == 0) client.Ask("bye");
  }

  void Act(ExtensionClient& client) {
    switch (random_() % 10) {
      case 0:
        client.Ask("subscribe", {{"from", "now"}});
        break;
      case 1:
        client.Ask("pause");
        if (random_() % 8 != 0) client.Ask("continue");  // else it forgets
        break;
      case 2:
        client.Ask("hook", {{"node", random_() % 6},
                            {"action", "replace"},
                            {"status", "FAILURE"},
                            {"position", random_() % 2 ? "before" : "after"},
                            {"times", 1 + random_() % 50}});
        break;
      case 3:
        client.Ask("hook", {{"node", random_() % 6}, {"times", 1}, {"condition", "number > 5"}});
        client.Ask("step", {{"to", random_() % 2 ? "node" : "tick"}});
        client.Ask("continue");
        break;
      case 4:
        client.Ask("hook", {{"node", 5}, {"action", "delay"}, {"delay_ms", 1}, {"times", 2}});
        break;
      case 5:
        client.Ask("write", {{"key", "number"}, {"value", random_() % 1000}});
        break;
      case 6:
        client.Ask("unhook");
        break;
      case 7:
        client.Ask("hooks");
        break;
      default:
        client.Ask(random_() % 2 ? "statistics" : "trees");
    }
  }

  int connections_ = 0;
  const std::uint16_t port_;
  std::mt19937 random_;
  const std::atomic<bool>& ends_;
};

TEST(LiveStress, EightClientsConnectPauseInjectAndDieDuringAHundredThousandTicks) {
  constexpr int kClients = 8;
  constexpr std::uint64_t kTicks = 100000;
  SimulatedClock clock;
  Executor executor(WatchedProgram(), clock);
  EventStream stream(executor);
  LiveOptions options = FreePort();
  options.deadline = 100ms;
  options.history_bytes = 1 << 20;
  LivePublisher live(stream, options);
  std::atomic<bool> ends{false};
  std::atomic<int> left{kClients};
  std::atomic<int> connections{0};
  std::vector<std::thread> clients;
  for (unsigned i = 0; i < kClients; ++i) {
    clients.emplace_back([&, i] {
      RandomClient client(live.port(), i, ends);
      client.Run();
      connections += client.connections();
      --left;
    });
  }
  for (std::uint64_t i = 0; i < kTicks; ++i) {
    executor.Tick();
    clock.Advance(1ms);
    if (i % 10 == 0) std::this_thread::sleep_for(100us);  // so that much happens meanwhile
  }
  ends = true;
  const auto deadline = SteadyClock::now() + 60s;
  const auto is_free = [&] { return left == 0 && live.debugger().hooks().empty(); };
  while (!is_free() && SteadyClock::now() < deadline) executor.Tick();
  EXPECT_TRUE(is_free()) << "what dead clients held is released";
  for (std::thread& client : clients) client.join();
  EXPECT_GT(connections, 5 * kClients);
  executor.Halt();
  Executor untouched(WatchedProgram(), clock);
  EXPECT_EQ(executor.Tick(), untouched.Tick());
  EXPECT_EQ(executor.statuses(), untouched.statuses());
}

class LiveFlowTest : public ::testing::Test {
 protected:
  void Subscribe(std::size_t history_bytes, std::size_t window = 4 << 20) {
    LiveOptions options = FreePort();
    options.history_bytes = history_bytes;
    options.deadline = 1h;
    live_.emplace(stream_, options);
    client_.emplace(live_->port());
    client_->Ask("hello");
    client_->Ask("subscribe", {{"window", window}});
  }

  // Takes the next push and acknowledges it. False if none comes in time.
  bool TakePush() {
    while (client_->pushes.empty()) {
      if (client_->Receive().empty()) return false;
    }
    const std::string push = client_->pushes.front();
    client_->pushes.erase(client_->pushes.begin());
    EXPECT_EQ(watcher_.Take(push).problem(), "");
    client_->socket().Send(
        {"", std::string("\x02") + "C" + std::string(4, '\0'),
         Json{{"do", "ack"}, {"subscription", 1}, {"next", watcher_.next}}.dump()});
    return true;
  }

  void Tick() {
    executor_.Tick();
    clock_.Advance(1ms);
  }

  SimulatedClock clock_;
  Executor executor_{WatchedProgram(), clock_};
  EventStream stream_{executor_};
  std::optional<LivePublisher> live_;
  std::optional<ExtensionClient> client_;
  Watcher watcher_;
};

TEST_F(LiveFlowTest, AnAttentiveClientMissesNothing) {
  constexpr std::uint64_t kTicks = 20000;
  Subscribe(32 << 20);
  std::thread ticking([&] {
    for (std::uint64_t i = 0; i < kTicks; ++i) {
      Tick();
      if (i % 100 == 99) stream_.Flush();  // so that the ring is never full
    }
  });
  while (watcher_.tick < kTicks && TakePush()) {
  }
  ticking.join();
  EXPECT_EQ(watcher_.nodes, 6u);
  EXPECT_EQ(watcher_.tick, kTicks);
  EXPECT_EQ(watcher_.lost, 0u);
  EXPECT_EQ(watcher_.holes, 0u);
}

TEST_F(LiveFlowTest, WhatASlowClientMissesIsCounted) {
  Subscribe(64 << 10, 32 << 10);
  std::uint64_t ticks = 0;
  for (int round = 0; round < 5; ++round) {
    for (int i = 0; i < 50000; ++i) {
      Tick();
      if (i % 100 == 99) stream_.Flush();
    }
    ticks += 50000;
    while (watcher_.tick < ticks && TakePush()) {
    }
    EXPECT_EQ(watcher_.tick, ticks);
  }
  EXPECT_GT(watcher_.lost, 1000u);
  EXPECT_EQ(watcher_.holes, 0u) << "every hole is told";
}

// p99 from the begin of the tick to its events in the hands of the client. Another program may have
// the computer now and then, so the best of some rounds counts.
// The time that it takes is printed; `./dev bench live` is the place to judge it.
TEST_F(LiveFlowTest, EveryTickArrivesBeforeTheNext) {
  constexpr int kTicks = 300;
  Subscribe(1 << 20);
  std::vector<SteadyClock::duration> times;
  for (int i = 0; i < kTicks; ++i) {
    const auto start = SteadyClock::now();
    Tick();
    while (watcher_.tick < executor_.ticks() && TakePush()) {
    }
    ASSERT_EQ(watcher_.tick, executor_.ticks());
    times.push_back(SteadyClock::now() - start);
    std::this_thread::sleep_until(start + 5ms);  // a tree that ticks 200 times a second
  }
  std::sort(times.begin(), times.end());
  const auto us = [](auto time) {
    return std::chrono::duration_cast<std::chrono::microseconds>(time).count();
  };
  std::cout << "status latency on loopback: median " << us(times[kTicks / 2]) << " us, p99 "
            << us(times[kTicks * 99 / 100]) << " us\n";
}

// In KiB.
long ResidentMemory() {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;) {
    long size = 0;
    if (word == "VmRSS:" && file >> size) return size;
  }
  return -1;
}

TEST_F(LiveFlowTest, MemoryStaysFlat) {
  if (kIsSanitized) GTEST_SKIP() << "the sanitizer keeps memory of its own";
  Subscribe(1 << 20);
  PlainClient(live_->port()).Ask({PlainClient::Header('r'), "start"});
  PlainClient groot2(live_->port());
  ExtensionClient idle(live_->port());  // subscribes and never reads
  idle.Ask("hello");
  idle.Ask("subscribe", {{"window", 64 << 10}});
  const auto run = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      Tick();
      if (i % 200 != 199) continue;
      stream_.Flush();
      groot2.Ask('t');
      while (watcher_.tick < executor_.ticks() && TakePush()) {
      }
    }
    return ResidentMemory();
  };
  const long before = run(40000);
  const long after = run(200000);
  EXPECT_LT(after - before, 2048) << "KiB";
}

}  // namespace
}  // namespace coppice
