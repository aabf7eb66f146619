// Follows a robot over the network, and debugs it.
//
//   class View : public LiveListener { void OnTick(const TickEvents& events) override {...} ... };
//   View view;
//   LiveClient client("robot:1667", view);
//   client.Send(MakeCommand(LiveCommand::Kind::kPause), [](const LiveReply& reply) {...});
//
// Robots with Coppice push every tick, nothing is lost. To others that know the Groot2 protocol
// (BehaviorTree.CPP 4) the client falls back by itself: it polls, fetches the transitions between
// polls, and makes the same history of them.
//
// It has one thread. A robot that is not there, or goes, is waited for: the client is back within a
// second after the robot, and goes on where it was. docs/live.md is the manual.
#ifndef COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_H_
#define COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_H_

#include <functional>
#include <memory>
#include <string>

#include "bt_core/live/client/client_types.h"

namespace coppice {

class LiveClient {
 public:
  /// `endpoint`: "host:port", or "host" for port 1667. The listener must outlive the client. Throws
  /// std::invalid_argument, with a text for people, if endpoint or token make no sense.
  LiveClient(const std::string& endpoint, LiveListener& listener, LiveClientOptions options = {});

  /// Takes leave of the robot, which releases at once what this client owns; waits for no answer.
  ~LiveClient();
  LiveClient(const LiveClient&) = delete;
  LiveClient& operator=(const LiveClient&) = delete;

  using ReplyHandler = std::function<void(const LiveReply&)>;

  /// Any thread. `on_reply` is called once, on the client's thread: with the robot's answer, or
  /// with an error if there is no connection or it breaks. Null: nobody wants to know.
  void Send(LiveCommand command, ReplyHandler on_reply = nullptr);

 private:
  class Loop;

  std::unique_ptr<Loop> loop_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_H_
