// Decides who may connect to sockets with CURVE: the ZAP handler of a ZeroMQ context (RFC 27). The
// role of a client goes with each of its messages, as their "User-Id".
#ifndef COPPICE_BT_CORE_LIVE_SERVER_CURVE_GATE_H_
#define COPPICE_BT_CORE_LIVE_SERVER_CURVE_GATE_H_

#include <zmq.hpp>

#include "bt_core/live/server/token_keys.h"

namespace coppice {

class CurveGate {
 public:
  static constexpr const char* kControl = "control";
  static constexpr const char* kRead = "read";

  /// Before the sockets are bound.
  CurveGate(zmq::context_t& context, RobotKeys keys);

  /// Makes a socket ask the gate; before it is bound.
  void Guard(zmq::socket_t& socket) const;

  /// Readable when somebody knocks.
  zmq::socket_t& socket() { return socket_; }
  /// Answers everybody who waits.
  void Serve();

  const std::string& read_token() const { return keys_.read_token; }

 private:
  const char* RoleOf(const std::string& public_key) const;

  const RobotKeys keys_;
  zmq::socket_t socket_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_CURVE_GATE_H_
