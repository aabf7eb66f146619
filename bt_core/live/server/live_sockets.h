// The two ZeroMQ sockets of a live view, bound to neighbouring ports.
//
// Requests arrive at a ROUTER, which looks to clients like a REP but never waits for one of them: a
// message without the empty part that a REQ puts before its request is dropped, and so is the
// answer to a client that has gone or does not read.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_LIVE_SOCKETS_H_
#define COPPICE_BT_CORE_LIVE_SERVER_LIVE_SOCKETS_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>
#include <zmq.hpp>

#include "bt_core/live/server/curve_gate.h"
#include "bt_core/live/server/live_outbox.h"
#include "bt_core/live/server/received_request.h"
#include "bt_core/live/server/wake_descriptor.h"

namespace coppice {

/// Used by one thread but for Wake.
class LiveSockets final : public LiveOutbox {
 public:
  /// Binds `port` for requests and port + 1 for notifications; 0 takes a free pair. With keys,
  /// nobody else can connect. Throws std::runtime_error with one line that names the port and says
  /// what to do.
  LiveSockets(const std::string& address, std::uint16_t port, std::optional<RobotKeys> keys = {});

  std::uint16_t port() const { return port_; }

  /// Waits for a request, a Wake, or until the time is over. Also lets clients in.
  void Wait(std::chrono::milliseconds patience);
  /// Any thread: ends the Wait that goes on, or the next one.
  void Wake() { wake_.Wake(); }

  /// False if there is no request now.
  bool Receive(ReceivedRequest& request);

  SendResult Send(const std::string& client, const groot2::Parts& parts) override;
  void Publish(const groot2::Parts& parts) override;

 private:
  void BindFreePair(const std::string& address);
  bool ReceiveMessage(ReceivedRequest& request);
  void MakeSockets();
  static void Bind(zmq::socket_t& socket, const std::string& address, int port);

  WakeDescriptor wake_;
  zmq::context_t context_;
  std::optional<CurveGate> gate_;
  zmq::socket_t requests_;
  zmq::socket_t notifications_;
  std::uint16_t port_ = 0;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_LIVE_SOCKETS_H_
