// The client's end of the live socket: requests and answers, what is published, when the robot is
// gone, and a bell with which another thread wakes who waits for all that. The client's thread
// only, but for the bell; it has no other.
#ifndef COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_SOCKET_H_
#define COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_SOCKET_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/live/client/client_connection.h"
#include "bt_core/live/server/token_keys.h"

namespace coppice {

/// Wakes the thread that waits at a ClientSocket.
class ClientBell {
 public:
  /// Throws std::system_error if the program has no descriptor left.
  ClientBell();
  ~ClientBell();
  ClientBell(const ClientBell&) = delete;
  ClientBell& operator=(const ClientBell&) = delete;

  /// Any thread.
  void Ring();

 private:
  friend class ClientSocket;

  bool TakeRing();

  const int fd_;
};

class ClientSocket {
 public:
  using Parts = std::vector<std::string>;

  /// Connects to `address` (AddressOf) when it can, again and again; with keys, which must live
  /// longer, encrypted.
  ClientSocket(ClientBell& bell, const std::string& address, const WatcherKeys* keys);
  ClientSocket(const ClientSocket&) = delete;
  ClientSocket& operator=(const ClientSocket&) = delete;

  /// Also receives what is published there, without encryption.
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

  /// What was sent last still goes out: waits for that, at most 100 ms.
  void Linger();

  /// Why there is no connection, for people; empty while that is not known.
  const std::string& problem() const { return problem_; }

 private:
  bool HasMessage() const;
  void OnGone();

  ClientBell& bell_;
  ClientConnection asking_;
  std::optional<ClientConnection> listening_;
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
