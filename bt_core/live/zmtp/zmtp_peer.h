// One client that speaks the protocol of ZeroMQ, seen from the robot: bytes in, whole messages out,
// and back. Knows no sockets; any bytes may be handed in.
//
//   ZmtpPeer peer(ZmtpPeer::Type::kRouter, &keys, limit);
//   peer.Receive(bytes);
//   while (peer.Next(message) == ZmtpPeer::Step::kMessage) ...
//   write(peer.TakeOutput());
//
// libzmq itself is not put before strangers: a client may choose the identity that libzmq's ROUTER
// knows it by, take that of another or, with that of the next one, end the process (4.3.4,
// socket_base.cpp); and a message of ever more parts takes all memory. Here the identity that a
// client names is passed over, and a message has a limit.
#ifndef COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_PEER_H_
#define COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_PEER_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "bt_core/live/groot2/groot2_protocol.h"
#include "bt_core/live/server/token_keys.h"
#include "bt_core/live/zmtp/zmtp_curve.h"
#include "bt_core/live/zmtp/zmtp_frames.h"

namespace coppice::zmtp {

class ZmtpPeer {
 public:
  /// What we are to it.
  enum class Type : std::uint8_t { kRouter, kPublisher };
  static constexpr std::size_t kMaxParts = 8;

  /// `keys`: null if there is no token; else must live longer. `max_bytes`: of a message.
  ZmtpPeer(Type type, const RobotKeys* keys, std::size_t max_bytes);

  /// Bytes that have arrived.
  void Receive(std::string_view bytes) { reader_.Append(bytes); }

  enum class Step : std::uint8_t { kMessage, kIncomplete, kRefused };
  /// The next whole message in what has arrived. Refused: hang up when the output is written.
  Step Next(groot2::Parts& message);

  /// What the protocol itself has to say; never much.
  std::string TakeOutput() { return std::exchange(output_, {}); }

  /// Messages go to and fro: the client is one that may connect.
  bool is_open() const { return state_ == State::kOpen; }
  bool may_control() const { return may_control_; }

  /// A message on its way to the client, once is_open().
  std::string Encode(const groot2::Parts& message);

 private:
  enum class State : std::uint8_t { kGreeting, kHello, kInitiate, kReady, kOpen };

  bool TakeCommand(std::string_view body);
  bool OnHello(std::string_view body);
  bool OnInitiate(std::string_view body);
  bool Open(std::string_view properties);
  bool TakePart(std::uint8_t flags, std::string_view body);
  void OnCommand(std::string_view body);
  void Say(std::string_view name, std::string_view body);
  const char* mechanism() const { return keys_ ? "CURVE" : "NULL"; }
  std::string Properties() const;

  const Type type_;
  const RobotKeys* const keys_;
  const std::size_t max_bytes_;
  State state_ = State::kGreeting;
  bool may_control_ = false;
  FrameReader reader_;
  std::optional<CurveConnection> curve_;
  std::string output_;
  groot2::Parts parts_;  // of the message that comes
  std::size_t size_ = 0;
  bool is_whole_ = false;
};

}  // namespace coppice::zmtp

#endif  // COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_PEER_H_
