// Follows one robot over the network, in a thread of its own.
//
// Asks for statuses about twenty times a second, for the watched blackboards twice a second, and
// for the tree whenever its id changes. A robot that does not answer in time is asked again over a
// new socket, with growing pauses, for ever; meanwhile the last known tree stays.
#ifndef COPPICE_EDITOR_LIVE_LIVE_CLIENT_H_
#define COPPICE_EDITOR_LIVE_LIVE_CLIENT_H_

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "editor/live/live_snapshot.h"

namespace coppice::editor {

struct LiveClientOptions {
  Duration status_period = std::chrono::milliseconds(50);
  Duration board_period = std::chrono::milliseconds(500);
  Duration reply_timeout = std::chrono::milliseconds(1000);
  Duration first_pause = std::chrono::milliseconds(200);  ///< doubles at each failure
  Duration longest_pause = std::chrono::milliseconds(3000);
};

class LiveClient : public LiveSource {
 public:
  /// Starts following. `endpoint` is "host:port". `on_change` is called in the client's thread
  /// after each new snapshot and must be quick. `clock` must outlive the client and stamps the
  /// snapshots.
  LiveClient(std::string endpoint, const Clock& clock, std::function<void()> on_change = {},
             LiveClientOptions options = {});

  /// Ends the thread; waits for no answer.
  ~LiveClient() override;

  const std::string& endpoint() const override { return endpoint_; }
  std::shared_ptr<const LiveSnapshot> snapshot() const override;
  void Watch(std::vector<std::string> boards) override;

 private:
  class Follower;

  std::vector<std::string> watched() const;
  void Publish(LiveSnapshot snapshot);

  const std::string endpoint_;
  const Clock& clock_;
  const std::function<void()> on_change_;
  const LiveClientOptions options_;

  mutable std::mutex mutex_;  // for the next two
  std::shared_ptr<const LiveSnapshot> snapshot_;
  std::vector<std::string> watched_;

  std::unique_ptr<Follower> follower_;
  std::thread thread_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_LIVE_CLIENT_H_
