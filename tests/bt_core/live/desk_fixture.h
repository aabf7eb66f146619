// The watched tree with what a live view knows of it, without sockets; and an outbox that keeps
// what is sent.
#ifndef COPPICE_TESTS_BT_CORE_LIVE_DESK_FIXTURE_H_
#define COPPICE_TESTS_BT_CORE_LIVE_DESK_FIXTURE_H_

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/live/server/live_outbox.h"
#include "bt_core/live/server/live_tree.h"
#include "tests/bt_core/live/watched_tree.h"

namespace coppice {

class KeepingOutbox : public LiveOutbox {
 public:
  std::size_t RoomFor(ClientId client) override {
    const auto result = results.find(client);
    return result != results.end() && result->second == SendResult::kFull ? 0 : SIZE_MAX;
  }
  SendResult Send(ClientId client, const groot2::Parts& parts) override {
    const auto result = results.find(client);
    if (result != results.end() && result->second != SendResult::kSent) return result->second;
    sent[client].push_back(parts);
    return SendResult::kSent;
  }
  SendResult Reply(ClientId client, const groot2::Parts& parts) override {
    const auto result = results.find(client);
    if (result != results.end() && result->second == SendResult::kGone) return SendResult::kGone;
    sent[client].push_back(parts);
    return SendResult::kSent;
  }
  void Publish(const groot2::Parts& parts) override { published.push_back(parts); }

  /// What was sent since the last call.
  std::vector<groot2::Parts> Take(ClientId client) { return std::exchange(sent[client], {}); }

  std::map<ClientId, SendResult> results;  // by client; kSent otherwise
  std::map<ClientId, std::vector<groot2::Parts>> sent;
  std::vector<groot2::Parts> published;
};

inline constexpr ClientId kAnn{1};
inline constexpr ClientId kBen{2};
inline constexpr ClientId kCem{3};

class LiveTreeFixture : public ::testing::Test {
 protected:
  explicit LiveTreeFixture(const LiveTreeOptions& options = {})
      : tree_(std::make_shared<LiveTree>(stream_, options, [this] { ++wakes_; })) {
    executor_.inbox()->set_ending(true);  // ticks are never held up
    stream_.Add(*tree_);
    stream_.Flush();
  }
  ~LiveTreeFixture() override { stream_.Remove(*tree_); }

  void Tick(int times = 1) {
    for (int i = 0; i < times; ++i) {
      executor_.Tick();
      clock_.Advance(std::chrono::milliseconds(1));
    }
    stream_.Flush();
  }

  std::atomic<int> wakes_{0};
  SimulatedClock clock_{std::chrono::seconds(1)};
  Executor executor_{WatchedProgram(), clock_};
  EventStream stream_{executor_};
  std::shared_ptr<LiveTree> tree_;
};

/// Of tests: one that refuses, one that may only be watched.
inline LiveTreeOptions Moving() {
  LiveTreeOptions options;
  options.permission = [] { return Problem{"the robot moves"}; };
  return options;
}
inline LiveTreeOptions ReadOnly() {
  LiveTreeOptions options;
  options.read_only = true;
  return options;
}

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_LIVE_DESK_FIXTURE_H_
