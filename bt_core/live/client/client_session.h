// What a client and a robot say to each other, over a connection that is there: one kind for each
// protocol.
#ifndef COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_SESSION_H_
#define COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_SESSION_H_

#include <functional>
#include <string>
#include <vector>

#include "bt_core/live/client/client.h"

namespace coppice {

/// The client's thread only. Times are in real time.
class ClientSession {
 public:
  using Parts = std::vector<std::string>;
  using Sender = std::function<void(const Parts&)>;

  virtual ~ClientSession() = default;

  /// After construction, and again when the time has come that it returns.
  virtual Duration OnTime(Duration now) = 0;
  virtual void OnMessage(const Parts& parts, Duration now) = 0;
  virtual void Send(const LiveCommand& command, LiveClient::ReplyHandler on_reply) = 0;
  /// In order, when the client ends.
  virtual void Leave() {}
  /// The connection is gone: nothing that was asked is answered any more.
  virtual void Abandon(const std::string& why) = 0;

  /// The robot has said something in this protocol.
  virtual bool has_answered() const = 0;
  /// The history comes.
  virtual bool is_live() const = 0;

  /// Why it cannot go on; empty while it can. Then the client tries again over another connection.
  const std::string& failure() const { return failure_; }
  /// The robot does not know this protocol.
  bool is_wrong_protocol() const { return is_wrong_protocol_; }

 protected:
  void Fail(std::string why) { failure_ = std::move(why); }
  void FailForProtocol() {
    is_wrong_protocol_ = true;
    failure_ = "the robot does not know this protocol";
  }

 private:
  std::string failure_;
  bool is_wrong_protocol_ = false;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_SESSION_H_
