// The robot, or any other ROUTER or PUB of ZeroMQ, seen from a client. Robots are strangers too: a
// message has its limits (zmtp_stream.h), and the memory for it is taken as it comes.
//
//   ZmtpClient robot(ZmtpClient::Type::kDealer, &keys, limit);
#ifndef COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CLIENT_H_
#define COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CLIENT_H_

#include <optional>

#include "bt_core/live/server/token_keys.h"
#include "bt_core/live/zmtp/zmtp_curve_client.h"
#include "bt_core/live/zmtp/zmtp_stream.h"

namespace coppice::zmtp {

class ZmtpClient final : public ZmtpStream {
 public:
  /// What we are to it. A listener has subscribed to everything when it is open.
  enum class Type : std::uint8_t { kDealer, kListener };

  /// `keys`: null if there is no token; else must live longer. `max_bytes`: of a message.
  ZmtpClient(Type type, const WatcherKeys* keys, std::size_t max_bytes);

 private:
  void OnGreeting() override;
  bool TakeCommand(std::string_view name, std::string_view body) override;
  bool OnWelcome(std::string_view body);
  bool OnReady(std::string_view properties);
  std::string Properties() const;

  const Type type_;
  std::optional<CurveClient> curve_;
};

}  // namespace coppice::zmtp

#endif  // COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CLIENT_H_
