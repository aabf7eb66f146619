// The two ZeroMQ sockets of a live view, bound to neighbouring ports.
//
// Requests arrive at a ROUTER, which looks to clients like a REP but never waits for one of them: a
// message without the empty part that a REQ puts before its request is dropped, and so is the
// answer to a client that has gone.
#ifndef COPPICE_BT_CORE_LIVE_SOCKET_PAIR_H_
#define COPPICE_BT_CORE_LIVE_SOCKET_PAIR_H_

#include <cstdint>
#include <string>
#include <vector>
#include <zmq.hpp>

namespace coppice {

class SocketPair {
 public:
  /// Binds `port` for requests and port + 1 for notifications; 0 takes a free pair. Throws
  /// std::runtime_error with one line that names the port and says what to do.
  SocketPair(const std::string& address, std::uint16_t port);

  std::uint16_t port() const { return port_; }

  /// Waits for a request. False once Shutdown was called.
  bool Receive(std::vector<std::string>& parts);

  /// Answers the request that came last.
  void Reply(const std::vector<std::string>& parts);

  /// Any thread: ends Receive.
  void Shutdown() { context_.shutdown(); }

 private:
  void BindFreePair(const std::string& address);
  void ReceiveMessage(std::vector<std::string>& parts);
  bool ReceivePart(zmq::message_t& part);
  void MakeSockets();
  static void Bind(zmq::socket_t& socket, const std::string& address, int port);

  zmq::context_t context_;
  zmq::socket_t requests_;
  zmq::socket_t notifications_;
  std::uint16_t port_ = 0;
  std::string client_;  // who sent the request that is being answered
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SOCKET_PAIR_H_
