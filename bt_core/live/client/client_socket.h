// The client's end of a connection: a DEALER socket that also tells when the robot is gone, and
// that another thread can wake.
#ifndef COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_SOCKET_H_
#define COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_SOCKET_H_

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>
#include <zmq.hpp>

#include "bt_core/base/clock.h"
#include "bt_core/live/server/token_keys.h"

namespace coppice {

/// Wakes the thread that waits at a ClientSocket.
class ClientBell {
 public:
  explicit ClientBell(zmq::context_t& context);
  /// Any thread.
  void Ring();

 private:
  friend class ClientSocket;

  std::mutex mutex_;
  zmq::socket_t in_;
  zmq::socket_t out_;
};

class ClientSocket {
 public:
  using Parts = std::vector<std::string>;

  /// Connects to `address` (AddressOf) when it can, again and again; with keys encrypted.
  ClientSocket(zmq::context_t& context, ClientBell& bell, const std::string& address,
               const WatcherKeys* keys);
  ~ClientSocket();
  ClientSocket(const ClientSocket&) = delete;
  ClientSocket& operator=(const ClientSocket&) = delete;

  /// Also receives what is published there.
  void Listen(const std::string& address);

  enum class Event : std::uint8_t {
    kMessage,  ///< Receive has something
    kBell,
    kGone,  ///< the connection is closed; problem() says why
    kTimeout,
  };
  Event Wait(Duration at_most);

  /// The parts of a message without the empty one that stands before them. Empty: nothing was
  /// there.
  Parts Receive();

  void Send(const Parts& parts);

  /// What was sent last still goes out when the socket is closed.
  void Linger();

  /// Why there is no connection, for people; empty while that is not known.
  const std::string& problem() const { return problem_; }

 private:
  bool ReadMonitor();
  static Parts ReceiveFrom(zmq::socket_t& socket);

  ClientBell& bell_;
  zmq::socket_t socket_;
  zmq::socket_t monitor_;
  zmq::socket_t published_;
  bool has_received_ = false;
  std::string problem_;
};

/// The address of the notifications, one port further.
std::string NotificationsOf(const std::string& address);

/// "tcp://host:port" for "host:port" or "host". Throws std::invalid_argument, with a text for
/// people.
std::string AddressOf(const std::string& endpoint);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_SOCKET_H_
