// A robot on the network: one with Coppice, or any that knows the Groot2 protocol.
#ifndef COPPICE_EDITOR_LIVE_ROBOT_SOURCE_H_
#define COPPICE_EDITOR_LIVE_ROBOT_SOURCE_H_

#include <functional>
#include <optional>
#include <string>

#include "editor/live/live_queue.h"
#include "editor/live/run_source.h"

namespace coppice::editor {

class RobotSource final : public RunSource {
 public:
  /// Follows the robot from now on, or one of its trees: "host:port/TREE". `wake` is called on
  /// another thread when there is news; it must be quick. Throws as LiveClient does.
  explicit RobotSource(std::string endpoint, std::function<void()> wake = {},
                       const LiveClientOptions& options = DefaultOptions());
  ~RobotSource() override { queue_.StopWaiting(); }
  RobotSource(const RobotSource&) = delete;
  RobotSource& operator=(const RobotSource&) = delete;

  /// Named as the editor, with the token of the environment.
  static LiveClientOptions DefaultOptions();

  const std::string& name() const override { return endpoint_; }
  bool is_robot() const override { return true; }
  void Pump(LiveListener& listener) override { queue_.Deliver(listener); }
  bool has_news() const override { return !queue_.empty(); }
  void HangUp(const std::string& why) override;
  void Send(LiveCommand command, LiveClient::ReplyHandler on_reply) override;

 private:
  const std::string endpoint_;
  LiveQueue queue_;
  std::optional<LiveClient> client_;
  std::string why_;  // there is no client
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_ROBOT_SOURCE_H_
