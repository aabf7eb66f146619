// One connection of a client to a port of a robot, over TCP: made again and again until there is
// one. Has no thread; whoever waits for it polls its descriptor.
//
// What the robot says is read message by message: while one waits here, nothing is read, and the
// robot is held up.
#ifndef COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_CONNECTION_H_
#define COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_CONNECTION_H_

#include <poll.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/live/client/large_messages.h"
#include "bt_core/live/client/name_lookup.h"
#include "bt_core/live/zmtp/zmtp_client.h"

namespace coppice {

class ClientConnection {
 public:
  using Parts = std::vector<std::string>;
  using Type = zmtp::ZmtpClient::Type;

  /// `address` as AddressOf makes it. `keys`, null if there is no token, must live longer.
  ClientConnection(Type type, const std::string& address, const WatcherKeys* keys);
  ~ClientConnection() { Close(); }
  ClientConnection(const ClientConnection&) = delete;
  ClientConnection& operator=(const ClientConnection&) = delete;

  /// What to poll for, and until when: then, or at once if something is there, comes Go.
  pollfd Wanted() const;
  Duration wake() const { return wake_; }
  void Go(short events, Duration now);

  bool has_message() const { return message_.has_value(); }
  /// Empty if there is none, and none can be read without waiting.
  Parts Receive();
  /// Goes out when there is a connection. Left out if the robot does not read what was sent before.
  void Send(const Parts& parts);
  /// Waits until all is sent and the robot has read it.
  void Finish(Duration at_most);

  /// There was a connection to the robot, and it has ended; for a listener another one is made.
  bool is_gone() const { return state_ == State::kGone; }
  /// It was ended here, for what the robot said.
  bool was_refused() const { return was_refused_; }

 private:
  enum class State : std::uint8_t { kPausing, kLooking, kConnecting, kTalking, kGone };

  void Look(Duration now);
  void ConnectToNext(Duration now);
  void OnConnected(Duration now);
  void Read();
  void Advance();
  void Write();
  void Pause(Duration now);
  void Lose();
  void Close();

  const Type type_;
  const std::string host_;
  const std::string port_;
  const WatcherKeys* const keys_;
  State state_ = State::kPausing;
  Duration wake_{0};
  std::optional<NameLookup> lookup_;
  std::vector<NetworkAddress> addresses_;
  std::size_t next_address_ = 0;
  int fd_ = -1;
  std::optional<zmtp::ZmtpClient> peer_;
  std::vector<Parts> waiting_;  // for a connection
  std::string unsent_;
  std::size_t sent_ = 0;  // of unsent_
  std::optional<Parts> message_;
  LargeMessages room_;  // of what comes, and of message_
  bool was_refused_ = false;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_CONNECTION_H_
