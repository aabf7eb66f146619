// A real robot in the process of the test, with its live view, ticked between the frames of the
// editor.
#ifndef COPPICE_TESTS_EDITOR_LIVE_LIVE_ROBOT_H_
#define COPPICE_TESTS_EDITOR_LIVE_LIVE_ROBOT_H_

#include <atomic>
#include <string>
#include <thread>

#include "bt_core/engine/events/event_stream.h"
#include "bt_core/live/debug/debugger.h"
#include "bt_core/live/server/live_publisher.h"
#include "tests/editor/timeline/executed_run.h"

namespace coppice::editor {

class LiveRobot {
 public:
  explicit LiveRobot(const std::string& trees, std::uint16_t port = 0)
      : tree(trees), stream_(tree.executor), live_(stream_, Options(port)) {}
  ~LiveRobot() { StopTicking(); }

  std::uint16_t port() const { return live_.port(); }
  std::string endpoint() const { return "127.0.0.1:" + std::to_string(port()); }

  /// On a thread of its own from now on, as a robot does: then it can be stopped.
  void StartTicking() {
    thread_ = std::thread([this] {
      while (!ends_) {
        tree.executor.RunCalls();
        tree.Tick(std::chrono::milliseconds(10));
        std::this_thread::yield();
      }
    });
  }
  void StopTicking() {
    ends_ = true;
    live_.debugger().ReleaseAll();
    if (thread_.joinable()) thread_.join();
  }
  /// One tick on this thread.
  void Tick() {
    tree.executor.RunCalls();
    tree.Tick(std::chrono::milliseconds(10));
  }

  ExecutedTree tree;

 private:
  static LiveOptions Options(std::uint16_t port) {
    LiveOptions options;
    options.port = port;
    return options;
  }

  EventStream stream_;
  LivePublisher live_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_LIVE_LIVE_ROBOT_H_
