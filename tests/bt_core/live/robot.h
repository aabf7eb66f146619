// A robot for tests of clients: a tree with a live view, which is ticked by hand or by a thread,
// and that can be switched off and on again at the same port.
#ifndef COPPICE_TESTS_BT_CORE_LIVE_ROBOT_H_
#define COPPICE_TESTS_BT_CORE_LIVE_ROBOT_H_

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "bt_core/engine/events/event_stream.h"
#include "bt_core/live/debug/debugger.h"
#include "bt_core/live/server/live_publisher.h"
#include "tests/bt_core/live/watched_tree.h"

namespace coppice {

class Robot {
 public:
  explicit Robot(LiveOptions options = WithPort(0)) : live_(stream_, options) {}
  ~Robot() { StopTicking(); }

  static LiveOptions WithPort(std::uint16_t port) {
    LiveOptions options;
    options.port = port;
    return options;
  }

  std::uint16_t port() const { return live_.port(); }
  std::string endpoint() const { return "127.0.0.1:" + std::to_string(port()); }

  void Tick(int times = 1) {
    for (int i = 0; i < times; ++i) {
      clock_.Advance(std::chrono::milliseconds(10));
      executor_.Tick();
    }
  }

  /// Ticks for ever, on another thread.
  void StartTicking() {
    thread_ = std::thread([this] {
      while (!stop_) {
        Tick();
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      }
    });
  }
  void StopTicking() {
    stop_ = true;
    executor_.inbox()->set_ending(true);
    if (thread_.joinable()) thread_.join();
  }

  Executor& executor() { return executor_; }
  LivePublisher& live() { return live_; }

 private:
  SimulatedClock clock_{std::chrono::seconds(1)};
  Executor executor_{WatchedProgram(), clock_};
  EventStream stream_{executor_};
  LivePublisher live_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_LIVE_ROBOT_H_
