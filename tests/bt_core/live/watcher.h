// A listener for tests of clients: keeps what it is told and lets a test wait for it.
#ifndef COPPICE_TESTS_BT_CORE_LIVE_WATCHER_H_
#define COPPICE_TESTS_BT_CORE_LIVE_WATCHER_H_

#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/engine/events/status_follower.h"
#include "bt_core/live/client/client.h"

namespace coppice {

struct Watched {
  std::vector<LiveConnection> connections;
  std::vector<TreeDescription> trees;
  std::vector<HistoryState> states;
  std::vector<std::uint64_t> ticks;  ///< their numbers
  std::vector<HistoryGap> gaps;
  std::vector<LiveNotice> notices;
  std::vector<LivePicture> pictures;
  std::vector<ForeignHook> foreign_hooks;  ///< as they are now
  std::size_t ends = 0;
  std::string frames;
  std::vector<std::string> values;  ///< per slot
  std::optional<StatusFollower> follower;

  bool is_live() const { return !connections.empty() && connections.back().is_live; }
  std::uint64_t last_tick() const { return ticks.empty() ? 0 : ticks.back(); }
};

class Watcher : public LiveListener {
 public:
  /// Waits until it holds; false if it does not within 30 s.
  template <class Condition>
  bool Await(Condition holds) {
    std::unique_lock<std::mutex> lock(mutex_);
    return came_.wait_for(lock, std::chrono::seconds(30), [&] { return holds(watched_); });
  }
  Watched watched() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return watched_;
  }

  void OnConnection(const LiveConnection& connection) override {
    Keep([&](Watched& w) { w.connections.push_back(connection); });
  }
  void OnTree(const TreeDescription& tree) override {
    Keep([&](Watched& w) { w.trees.push_back(tree); });
  }
  void OnState(const HistoryState& state) override {
    Keep([&](Watched& w) {
      w.states.push_back(state);
      w.values = state.values;
      w.follower.emplace(ShapeOf(w.trees.back()), state.statuses);
    });
  }
  void OnTick(const TickEvents& events) override {
    Keep([&](Watched& w) {
      if (events.result != Status::kIdle) w.ticks.push_back(events.tick);
      EventReader reader(events.words);
      for (Event event; reader.Next(event);) {
        w.follower->Apply(event);
        const bool is_value = event.code == EventCode::kWrite || event.code == EventCode::kDelivery;
        if (is_value) w.values.at(event.index) = event.bytes;
      }
    });
  }
  void OnGap(const HistoryGap& gap) override {
    Keep([&](Watched& w) { w.gaps.push_back(gap); });
  }
  void OnEnd(const HistoryEnd&) override {
    Keep([](Watched& w) { ++w.ends; });
  }
  void OnNotice(const LiveNotice& notice) override {
    Keep([&](Watched& w) { w.notices.push_back(notice); });
  }
  void OnPicture(const LivePicture& picture) override {
    Keep([&](Watched& w) { w.pictures.push_back(picture); });
  }
  void OnForeignHooks(const std::vector<ForeignHook>& hooks) override {
    Keep([&](Watched& w) { w.foreign_hooks = hooks; });
  }
  void OnFrame(const std::uint8_t* frame, std::size_t size) override {
    Keep([&](Watched& w) { w.frames.append(reinterpret_cast<const char*>(frame), size); });
  }

 private:
  template <class Change>
  void Keep(Change change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    change(watched_);
    came_.notify_all();
  }

  mutable std::mutex mutex_;
  std::condition_variable came_;
  Watched watched_;
};

/// Sends a command and waits for what comes of it.
inline LiveReply Ask(LiveClient& client, LiveCommand command) {
  auto promise = std::make_shared<std::promise<LiveReply>>();
  std::future<LiveReply> reply = promise->get_future();
  client.Send(std::move(command), [promise](const LiveReply& r) { promise->set_value(r); });
  if (reply.wait_for(std::chrono::seconds(30)) != std::future_status::ready) {
    return Problem{"no reply within 30 s"};
  }
  return reply.get();
}

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_LIVE_WATCHER_H_
