// One client that speaks the protocol of ZeroMQ, seen from the robot.
//
//   ZmtpPeer peer(ZmtpPeer::Type::kRouter, &keys, limit);
//
// libzmq itself is not put before strangers: a client may choose the identity that libzmq's ROUTER
// knows it by, take that of another or, with that of the next one, end the process (4.3.4,
// socket_base.cpp); and a message of ever more parts takes all memory. Here the identity that a
// client names is passed over, and a message has a limit.
#ifndef COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_PEER_H_
#define COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_PEER_H_

#include <optional>

#include "bt_core/live/server/token_keys.h"
#include "bt_core/live/zmtp/zmtp_curve.h"
#include "bt_core/live/zmtp/zmtp_stream.h"

namespace coppice::zmtp {

class ZmtpPeer final : public ZmtpStream {
 public:
  /// What we are to it.
  enum class Type : std::uint8_t { kRouter, kPublisher };

  /// `keys`: null if there is no token; else must live longer. `max_bytes`: of a message.
  ZmtpPeer(Type type, const RobotKeys* keys, std::size_t max_bytes);

  bool may_control() const { return may_control_; }

 private:
  bool TakeCommand(std::string_view name, std::string_view body) override;
  bool OnHello(std::string_view body);
  bool OnInitiate(std::string_view body);
  bool IsLetIn(std::string_view properties) const;
  std::string Properties() const;

  const Type type_;
  const RobotKeys* const keys_;
  bool may_control_ = false;
  bool was_welcomed_ = false;
  std::optional<CurveConnection> curve_;
};

}  // namespace coppice::zmtp

#endif  // COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_PEER_H_
